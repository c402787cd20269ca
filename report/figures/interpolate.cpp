// Figures of interpolation. The library finds the triangles, and the submission interpolates over them.
#include "debug/false_color.h"
#include "report/figure.h"
#include "report/pictures.h"
#include "report/studio.h"
#include "values/stopwatch.h"
#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace report::interpolate {
namespace {

    using debug::Quantity;

    worker::RenderRequest monkey(const std::string& normalInterp, Quantity quantity)
    {
        auto request = sceneNamed("normal_interpolation", { 520, 520 }, { "normal_interp=" + normalInterp });
        request.quantity = quantity;
        return request;
    }

    worker::Rendering interpolated(Studio& studio, Who who, const worker::RenderRequest& request)
    {
        const values::Stopwatch watch;
        auto rendering = studio.ask<worker::Rendering>(who, "figures.interpolated", request);
        rendering.seconds = watch.seconds();
        return rendering;
    }

    bool isThere(const glm::vec3& value)
    {
        return value != debug::nothing;
    }

    // Of all pairs of pixels side by side that show the model, those with one and the same normal, in percent.
    double percentEqual(const worker::Rendering& normals)
    {
        std::size_t equal = 0, pairs = 0;
        for (std::size_t i = 1; i < normals.pixels.size(); ++i) {
            const glm::vec3 &a = normals.pixels[i - 1], &b = normals.pixels[i];
            if (i % static_cast<std::size_t>(normals.size.x) == 0 || !isThere(a) || !isThere(b))
                continue;
            equal += a == b;
            ++pairs;
        }
        return 100.0 * static_cast<double>(equal) / static_cast<double>(std::max<std::size_t>(pairs, 1));
    }

    std::string withLabel(const Studio& studio)
    {
        return studio.nameOf(Who::Submission) + ", interpolated";
    }

    Sheet drawOnAndOff(Studio& studio)
    {
        const auto request = monkey("true", Quantity::Color);
        const worker::Rendering rendering = interpolated(studio, Who::Submission, request);
        const Picture before = toPicture(
            "one normal a triangle", interpolated(studio, Who::Submission, monkey("false", Quantity::Color)));
        const Picture after = toPicture(withLabel(studio), rendering);
        const Picture reference = toPicture("reference", interpolated(studio, Who::Reference, request));
        const worker::Rendering normals = interpolated(studio, Who::Submission, monkey("true", Quantity::Normal));
        std::size_t changed = 0, beside = 0;
        for (std::size_t i = 0; i < normals.pixels.size(); ++i)
            if (before.pixels[i] != after.pixels[i])
                ++(isThere(normals.pixels[i]) ? changed : beside);

        Sheet sheet { .panels = { Slider { before, after }, reference }, .facts = factsOf(request, rendering) };
        sheet.facts.push_back(errorAgainst(reference, after));
        sheet.claims
            = { { fmt::format("{} pixels of the model change their shade, and {} beside it: the outline stays.",
                      changed, beside),
                changed > 0 && beside == 0 } };
        sheet.data = { { "changed", changed }, { "beside", beside } };
        return sheet;
    }

    Sheet drawNormals(Studio& studio)
    {
        const auto request = monkey("true", Quantity::Normal);
        const worker::Rendering flat = interpolated(studio, Who::Submission, monkey("false", Quantity::Normal));
        const worker::Rendering smooth = interpolated(studio, Who::Submission, request);
        const auto picture = [](const std::string& label, const worker::Rendering& normals) {
            return toFalseColors(label, Quantity::Normal, normals);
        };
        double offUnit = 0.0;
        for (const glm::vec3& normal : smooth.pixels)
            if (isThere(normal))
                offUnit = std::max(offUnit, std::abs(1.0 - glm::length(glm::dvec3(normal))));
        const Picture after = picture(withLabel(studio), smooth);
        const Picture reference = picture("reference", interpolated(studio, Who::Reference, request));

        Sheet sheet { .panels = { Slider { picture("one normal a triangle", flat), after }, reference },
            .facts = factsOf(request, smooth) };
        sheet.facts.push_back(errorAgainst(reference, after));
        const double flatEqual = percentEqual(flat), smoothEqual = percentEqual(smooth);
        sheet.claims = { { fmt::format("Of the pixels side by side {:.1f} % share a normal with one normal a triangle, "
                                       "{:.1f} % with interpolated ones, whose length is 1 but for {:.1g}.",
                               flatEqual, smoothEqual, offUnit),
            smoothEqual < 0.1 * flatEqual && offUnit < 1e-5 } };
        sheet.data = { { "flat", flatEqual }, { "smooth", smoothEqual }, { "off unit", offUnit } };
        return sheet;
    }

    worker::RenderRequest barycentrics(const std::string& scene)
    {
        auto request = sceneNamed(scene, { 520, 520 });
        request.quantity = Quantity::Barycentric;
        return request;
    }

    // How far sums are from 1 and weights from [0, 1].
    struct Deviation {
        double sum = 0.0, outside = 0.0;
    };

    void add(Deviation& deviation, const worker::Rendering& rendering)
    {
        for (const glm::vec3& bc : rendering.pixels) {
            if (!isThere(bc))
                continue;
            deviation.sum = std::max(deviation.sum, std::abs(1.0 - (double(bc.x) + double(bc.y) + double(bc.z))));
            for (int i = 0; i < 3; ++i)
                deviation.outside = std::max({ deviation.outside, -double(bc[i]), double(bc[i]) - 1.0 });
        }
    }

    Sheet drawBarycentric(Studio& studio)
    {
        Sheet sheet;
        Deviation deviation;
        for (const std::string scene : { "single_triangle", "monkey" }) {
            const auto request = barycentrics(scene);
            const worker::Rendering own = interpolated(studio, Who::Submission, request);
            add(deviation, own);
            const Picture picture = toFalseColors(studio.nameOf(Who::Submission), Quantity::Barycentric, own);
            const Picture reference
                = toFalseColors("reference", Quantity::Barycentric, interpolated(studio, Who::Reference, request));
            sheet.panels.insert(sheet.panels.end(), { picture, reference });
            if (sheet.facts.empty())
                sheet.facts = factsOf(request, own);
            sheet.facts.push_back(errorAgainst(reference, picture));
        }
        constexpr double roundings = 1e-6; // of three numbers of at most 1
        sheet.claims = { { fmt::format("alpha is red, beta green, gamma blue. Their sums are 1 but for {:.1g}; none is "
                                       "beyond [0, 1] by more than {:.1g}.",
                               deviation.sum, deviation.outside),
            deviation.sum <= roundings && deviation.outside <= roundings } };
        sheet.data = { { "sum", deviation.sum }, { "outside", deviation.outside } };
        return sheet;
    }

    const Figure onAndOff(
        "interpolation.on_and_off", "Shading before and after interpolation", Part::RenderedImages, drawOnAndOff);
    const Figure normals(
        "interpolation.normals", "Normals as colours, before and after", Part::VisualDebugging, drawNormals);
    const Figure barycentric(
        "interpolation.barycentric", "Barycentric coordinates as colours", Part::VisualDebugging, drawBarycentric);

}
}
