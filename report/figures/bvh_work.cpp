// What is done for a picture, and what is left out, and why.
#include "report/figure.h"
#include "report/pictures.h"
#include "report/studio.h"
#include "worker/explanation.h"
#include <algorithm>
#include <fmt/format.h>

namespace report::bvh_work {
namespace {

    using Lines = std::vector<worker::ExplainedLine>;

    worker::Explanation explain(Studio& studio, Who who, const std::string& scene)
    {
        return studio.ask<worker::Explanation>(who, "render.explain", sceneNamed(scene, { 200, 150 }));
    }

    // A column for each picture; all have the same lines.
    Table tableOf(const std::string& label, const std::vector<std::string>& pictures, const std::vector<Lines>& columns)
    {
        Table table { label, { "" }, {} };
        table.head.insert(table.head.end(), pictures.begin(), pictures.end());
        for (std::size_t i = 0; i < columns.front().size(); ++i) {
            std::vector<std::string>& row = table.rows.emplace_back(1, columns.front()[i].what);
            for (const Lines& column : columns)
                row.push_back(column.at(i).value);
        }
        return table;
    }

    Sheet drawWork(Studio& studio)
    {
        const std::string box = "cornell_box", cube = "cube_textured", name = studio.nameOf(Who::Submission);
        const worker::Explanation own = explain(studio, Who::Submission, box),
                                  expected = explain(studio, Who::Reference, box),
                                  textured = explain(studio, Who::Submission, cube),
                                  expectedTextured = explain(studio, Who::Reference, cube);
        Sheet sheet { .panels
            = { tableOf("done for pictures of 200 × 150 pixels",
                    { box + ", " + name, box + ", reference", cube + ", " + name, cube + ", reference" },
                    { linesOfWork(own), linesOfWork(expected), linesOfWork(textured), linesOfWork(expectedTextured) }),
                tableOf(
                    worker::titleOfNeeds(own.skips), { box, cube }, { linesOf(own.parts), linesOf(textured.parts) }) },
            .columns = 1,
            .facts = { { "seed", "0" } } };
        const accel::RayCounts& rays = own.work.rays;
        const uint64_t theirs = expected.work.rays.total();
        sheet.claims = { { fmt::format("In the Cornell box {} rays are traced, by the reference {}. Of those to lights "
                                       "{} are left out: the surface could "
                                       "not show the light.",
                               rays.total(), theirs, rays.unlit),
            rays.total() <= theirs + theirs / 10 } };
        sheet.data = { { "camera", rays.camera }, { "bounced", rays.bounced }, { "shadow", rays.shadow },
            { "unlit", rays.unlit }, { "nodes", own.work.numNodes }, { "triangles", own.work.numTriangles },
            { "lookups", textured.work.numLookups } };
        return sheet;
    }

    const Figure work("bvh.work", "What is done for a picture, and what is left out", Part::VisualDebugging, drawWork);

}
}
