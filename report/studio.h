#pragma once
#include "report/sheet.h"
#include "worker/debug_ray.h"
#include "worker/process.h"
#include "worker/render_request.h"
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace report {

enum class Who { Submission, Reference };

// A figure met functions of its section that are still stubs.
class NotWritten : public std::runtime_error {
public:
    explicit NotWritten(const std::vector<std::string>& functions);
};

// Whom figures are drawn of, and what else they are drawn from.
struct Subject {
    std::string name; // of the submission, as readers know it
    std::filesystem::path submission, reference; // programs, linked with the probes of figures
    std::vector<std::filesystem::path> results; // folders with what other commands wrote, such as grade.json
};

// The file of that name in the first folder that has one; empty if none has.
[[nodiscard]] std::filesystem::path findResult(const Subject& subject, const std::string& file);

// Where one figure is drawn: it has workers of its own, which start when they are first asked. All that asks throws
// NotWritten when a function of the figure's section is a stub, worker::Failure when the submission's code crashes or
// takes too long, and worker::ProbeError.
class Studio {
public:
    Studio(const Subject& subject, std::string section);

    // What a probe answers: one of the framework's (render.image, debug.ray), or one in report/probes.
    template <typename Result, typename... Inputs>
    [[nodiscard]] Result ask(Who who, const std::string& probe, const Inputs&... inputs)
    {
        worker::Message message;
        (message << ... << inputs);
        const worker::Message answer = run(who, probe, message);
        worker::Reader reader { answer };
        return reader.read<Result>();
    }

    [[nodiscard]] worker::Rendering render(Who who, const worker::RenderRequest& request);
    [[nodiscard]] worker::DebugRay followRay(Who who, const worker::RenderRequest& request, glm::ivec2 pixel);

    // For labels: the submission's name, or "reference".
    [[nodiscard]] std::string nameOf(Who who) const;

    // What another command wrote; one of the figure's results.
    [[nodiscard]] nlohmann::json result(const std::string& file) const;

    // Functions of other sections that are stubs and were met.
    [[nodiscard]] const std::vector<std::string>& stubs() const { return m_stubs; }

private:
    worker::Message run(Who who, const std::string& probe, const worker::Message& message);
    void note(const std::vector<std::string>& unwritten);

    const Subject& m_subject;
    std::string m_section;
    std::unique_ptr<worker::Process> m_processes[2];
    std::vector<std::string> m_stubs;
};

// A scene of scenes/, or of report/scenes/, in that size, with "name=value" in place of what the file says.
[[nodiscard]] worker::RenderRequest sceneNamed(
    const std::string& name, glm::ivec2 size, std::vector<std::string> settings = {});

[[nodiscard]] Picture toPicture(std::string label, worker::Rendering rendering);

// Quantities other than colours as false colours over their range.
[[nodiscard]] Picture toFalseColors(std::string label, debug::Quantity quantity, worker::Rendering rendering);

// What a debug ray drew, over the darkened picture of the same request.
[[nodiscard]] Drawing toDrawing(std::string label, const worker::DebugRay& ray, const worker::Rendering& rendering);

// One scene by both, the submission's picture over the reference's under a slider, with the facts and the error.
[[nodiscard]] Sheet againstReference(Studio& studio, const worker::RenderRequest& request);

// Scene, size, settings that were changed, samples and seed; of a rendering of it, rays and seconds too.
[[nodiscard]] std::vector<Fact> factsOf(const worker::RenderRequest& request);
[[nodiscard]] std::vector<Fact> factsOf(const worker::RenderRequest& request, const worker::Rendering& rendering);

// Such as "1 a pixel, 32 a light"; a point light has but one.
[[nodiscard]] std::string samplesOf(const worker::RenderRequest& request);

}
