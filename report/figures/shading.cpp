// What the gradient models look like.
#include "report/figure.h"
#include "report/pictures.h"
#include "report/plot.h"
#include "report/probes/shading_question.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report {
namespace {

    // The same scene by both.
    Sheet sideBySide(Studio& studio, const worker::RenderRequest& request)
    {
        const worker::Rendering own = studio.render(Who::Submission, request);
        const Picture picture = toPicture(studio.nameOf(Who::Submission), own);
        const Picture reference = toPicture("reference", studio.render(Who::Reference, request));
        Sheet sheet;
        sheet.panels = { picture, reference };
        sheet.facts = factsOf(request, own);
        sheet.facts.push_back(errorAgainst(reference, picture));
        return sheet;
    }

    const Figure gradient("shading.gradient", "The linear gradient on a sphere and a cube", [](Studio& studio) {
        return sideBySide(studio, sceneNamed("gradient", { 520, 260 }));
    });

}
}
