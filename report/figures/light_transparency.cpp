// What is left of light behind a transparent surface: the old formula, and the one that was proposed in its place.
#include "report/figure.h"
#include "report/pictures.h"
#include "report/plot.h"
#include "report/probes/light_question.h"
#include "report/studio.h"
#include <fmt/format.h>

namespace report::light_transparency {
namespace {

    const char* const proposedSetting = "proposed_shadow_formula=true";

    // ---- Rendered

    // A submission need not know of the proposal: then the reference shows it.
    struct Proposed {
        Picture picture;
        bool isOwn = true;
    };

    Proposed renderProposed(Studio& studio, const std::string& scene, glm::ivec2 size, const Picture& old)
    {
        const worker::RenderRequest request = sceneNamed(scene, size, { proposedSetting });
        const Picture own
            = toPicture("Proposed, " + studio.nameOf(Who::Submission), studio.render(Who::Submission, request));
        if (rmse(own, old) > 0.0)
            return { own };
        return { toPicture("Proposed, reference", studio.render(Who::Reference, request)), false };
    }

    Sheet render(Studio& studio)
    {
        Sheet sheet;
        nlohmann::json gaps;
        bool isOwn = true;
        for (const std::string scene : { "panes", "transparent_shadows" }) {
            constexpr glm::ivec2 size { 520, 300 };
            const worker::RenderRequest request = sceneNamed(scene, size);
            const worker::Rendering rendering = studio.render(Who::Submission, request);
            const Picture old = toPicture("Old, " + studio.nameOf(Who::Submission), rendering);
            const Picture reference = toPicture("Old, reference", studio.render(Who::Reference, request));
            const Proposed proposed = renderProposed(studio, scene, size, old);
            sheet.panels.emplace_back(Slider { old, proposed.picture });
            sheet.panels.emplace_back(difference("Difference, twice as bright", old, proposed.picture, 2.0f));
            gaps[scene] = rmse(old, proposed.picture);
            sheet.facts.push_back({ scene + ".toml",
                fmt::format("{:.2f} s, RMSE against the reference {:.2g}, between the formulas {:.2g}",
                    rendering.seconds, rmse(reference, old), rmse(old, proposed.picture)) });
            isOwn = isOwn && proposed.isOwn;
        }
        sheet.facts.push_back({ "alpha of the panes", "1, 0.75, 0.5, 0.25, 0, from left to right" });
        sheet.facts.push_back({ "samples", "1 a pixel" });
        sheet.facts.push_back({ "seed", "0" });
        if (!isOwn)
            sheet.facts.push_back({ "proposed formula", "the reference's: this code does not ask for it" });
        sheet.data = { { "gaps", gaps }, { "proposed_is_own", isOwn } };
        return sheet;
    }

    // ---- Against alpha

    constexpr float kd = 0.3f;

    double left(double alpha)
    {
        return kd * (1.0 - alpha);
    }

    // t: how much of the light the surface lets through as it is.
    double leftProposed(double t)
    {
        return kd * (1.0 - t) + t;
    }

    std::vector<double> behindPanes(Studio& studio, Who who, const std::vector<float>& alphas, bool isProposed)
    {
        std::vector<double> light;
        for (const glm::vec3& color : studio.ask<std::vector<glm::vec3>>(
                 who, "figures.light_behind_pane", PanesQuestion { glm::vec3(kd), alphas, isProposed }))
            light.push_back(color.x);
        return light;
    }

    struct Curves {
        std::vector<float> alphas;
        std::vector<double> old, proposed; // measured
        bool proposedIsOwn = true;
    };

    Curves measure(Studio& studio)
    {
        Curves curves;
        for (int i = 0; i <= 20; ++i)
            curves.alphas.push_back(static_cast<float>(i) / 20.0f);
        curves.alphas.insert(curves.alphas.end() - 1, 0.999f); // just before a surface is opaque
        curves.old = behindPanes(studio, Who::Submission, curves.alphas, false);
        curves.proposed = behindPanes(studio, Who::Submission, curves.alphas, true);
        curves.proposedIsOwn = curves.proposed != curves.old;
        if (!curves.proposedIsOwn)
            curves.proposed = behindPanes(studio, Who::Reference, curves.alphas, true);
        return curves;
    }

    std::vector<std::vector<double>> toRows(const std::vector<float>& alphas, const std::vector<double>& light)
    {
        std::vector<std::vector<double>> rows;
        for (std::size_t i = 0; i < alphas.size(); ++i)
            rows.push_back({ static_cast<double>(alphas[i]), light[i] });
        return rows;
    }

    Plot plotOf(const Curves& curves)
    {
        return { "What is left of white light behind a surface with kd 0.3: points by the code, lines by the formulas",
            dataBlock("old", toRows(curves.alphas, curves.old))
                + dataBlock("proposed", toRows(curves.alphas, curves.proposed))
                + fmt::format(R"gp(kd = {:.9g}
set xrange [-0.02:1.02]; set yrange [-0.03:1.05]; set xlabel "alpha"; set ylabel "light that is left"
set key outside right top Left reverse width -6; set xtics 0.25; set ytics 0.25
plot [0:1] kd * (1 - x) with lines linetype 1 title "old: kd (1 - α)", \
     kd * x + (1 - x) with lines linetype 2 title "proposed, t = 1 - α", \
     kd * (1 - x) + x with lines linetype 4 title "proposed, t = α", \
     1 - x with lines linetype 7 dashtype 2 title "a ray passed through: 1 - α", \
     (1 - x) * (kd * x + 1 - x) with lines linetype 3 dashtype 4 title "(1 - α) × proposed", \
     $old using 1:2 with points linetype 1 title "old, by the code", \
     $proposed using 1:2 with points linetype 2 title "proposed, by the code", {}, {}
)gp",
                    kd, hoverPoints("old", 1), hoverPoints("proposed", 2)),
            { 720, 360 } };
    }

    Table tableOf()
    {
        Table table { "Light that is left where kd = 0.3",
            { "alpha", "passed through: 1 - α", "old: kd (1 - α)", "proposed, t = 1 - α", "proposed, t = α",
                "(1 - α) × proposed" } };
        for (const double alpha : { 0.0, 0.5, 1.0 }) {
            std::vector<std::string>& row = table.rows.emplace_back();
            for (const double value : { alpha, 1.0 - alpha, left(alpha), leftProposed(1.0 - alpha), leftProposed(alpha),
                     (1.0 - alpha) * leftProposed(1.0 - alpha) })
                row.push_back(fmt::format("{:.3g}", value));
        }
        return table;
    }

    double largestGap(const Curves& curves, const std::vector<double>& light, double (*formula)(double))
    {
        double largest = 0.0;
        for (std::size_t i = 0; i < light.size(); ++i)
            largest = std::max(largest, std::abs(light[i] - formula(static_cast<double>(curves.alphas[i]))));
        return largest;
    }

    // The exception that the proposal needs to keep opaque surfaces opaque.
    double leftProposedOrNone(double alpha)
    {
        return alpha == 1.0 ? 0.0 : leftProposed(1.0 - alpha);
    }

    std::vector<Claim> claimsOf(const Curves& curves, double gapOld, double gapProposed)
    {
        constexpr double rounding = 1e-5; // of a few products of floats
        const double clearOld = curves.old.front(), clearProposed = curves.proposed.front();
        const double nearlyOpaque = *(curves.proposed.end() - 2), opaque = curves.old.back();
        return {
            { fmt::format(
                  "The old formula is right for an opaque surface, which leaves {:.2g}, and wrong for a clear one: "
                  "it leaves {:.2g} where nothing is in the way. Alpha scales the light; nothing lets kd fade out.",
                  opaque, clearOld),
                opaque == 0.0 && std::abs(clearOld - kd) < rounding },
            { fmt::format(
                  "The proposal is plausible for t = 1 - α, what is let through: then a clear surface leaves "
                  "{:.2g}. But one of alpha 0.999 leaves {:.2g}, though nobody sees through it; alpha 1 needs an "
                  "exception. With t = α it is wrong at both ends: a clear surface leaves kd, an opaque one all.",
                  clearProposed, nearlyOpaque),
                std::abs(clearProposed - 1.0) < rounding && std::abs(nearlyOpaque - kd) < 0.01 },
            { fmt::format("The code computes the formulas: the largest differences are {:.1g} and {:.1g}.", gapOld,
                  gapProposed),
                gapOld < rounding && gapProposed < rounding },
        };
    }

    Sheet plot(Studio& studio)
    {
        const Curves curves = measure(studio);
        const double gapOld = largestGap(curves, curves.old, left);
        const double gapProposed = largestGap(curves, curves.proposed, leftProposedOrNone);
        Sheet sheet;
        sheet.columns = 1;
        sheet.panels = { plotOf(curves), tableOf() };
        sheet.facts = { { "surface", "one pane, kd 0.3" }, { "light", "1" }, { "random numbers", "none" } };
        if (!curves.proposedIsOwn)
            sheet.facts.push_back({ "proposed formula", "the reference's: this code does not ask for it" });
        sheet.claims = claimsOf(curves, gapOld, gapProposed);
        sheet.data = { { "alpha", curves.alphas }, { "old", curves.old }, { "proposed", curves.proposed },
            { "proposed_is_own", curves.proposedIsOwn } };
        return sheet;
    }

    const Figure rendered("light.transparent_shadows", "Transparent shadows by the old and the proposed formula",
        Part::RenderedImages, render);
    const Figure formula("light.formula", "The formulas of transparent shadows, by alpha", Part::VisualDebugging, plot);

}
}
