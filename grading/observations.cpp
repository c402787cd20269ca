#include "grading/observations.h"
#include "files/feature_settings.h"
#include "files/scene_file.h"
#include "grading/drawn/own.h"
#include "grading/drawn/words.h"
#include "grading/harmless.h"
#include "grading/worker_limits.h"
#include "submission/paths.h"
#include "worker/debug_ray.h"
#include <algorithm>
#include <fmt/format.h>

namespace grading {
namespace {

    // A ray that meets what a feature is for, has no branches and stays within the scene.
    struct Question {
        std::string feature, scene;
        std::vector<std::pair<std::string, std::string>> settings;
        glm::ivec2 pixel; // of 64 x 64
    };

    using Settings = decltype(Question::settings);
    const Settings noShadows { { "shadows", "false" } };
    // The library's own traversal draws nothing; but the solution's alone asks for interpolation.
    const Settings noBoxes { { "shadows", "false" }, { "accel_structure", "false" } };

    const std::vector<Question> questions {
        { "shading", "gradient", noBoxes, { 22, 29 } },
        { "reflection", "reflections", noBoxes, { 31, 40 } },
        { "transparency", "transparency", noBoxes, { 22, 29 } },
        { "bvh", "normal_interpolation", noShadows, { 22, 29 } },
        { "interpolation", "normal_interpolation", noShadows, { 22, 29 } },
        { "texture", "texture_nearest", noBoxes, { 22, 36 } },
        { "light", "soft_shadows", { { "shadow_samples", "16" }, { "accel_structure", "false" } }, { 30, 16 } },
    };

    worker::Message toMessage(const Question& question)
    {
        worker::DebugRayRequest request;
        request.render.scene = "scenes/" + question.scene + ".toml";
        for (const auto& [name, value] : question.settings)
            request.render.settings.push_back(name + "=" + value);
        request.render.size = { 64, 64 };
        request.pixel = question.pixel;
        worker::Message message;
        message << request;
        return message;
    }

    const std::string debugRay = "render.debug_ray";

    worker::DebugRay toRay(const worker::Message& message)
    {
        worker::Reader reader { message };
        return reader.read<worker::DebugRay>();
    }

    worker::DebugRay askSubmission(const Observed& observed, const worker::Message& question, const KeptMessages& known)
    {
        if (const auto answer = known.find(observed.key))
            return toRay(*answer);
        constexpr std::chrono::seconds patience { 2 }; // of which one ray takes the solution next to nothing
        worker::Limits limits = limitsOfWorkers();
        limits.answerBytes = std::size_t(16) << 20; // a full recording is smaller
        const worker::Message answer
            = worker::Process(observed.program, limits).ask(debugRay, question, patience).output;
        worker::DebugRay ray = toRay(answer);
        known.keep(observed.key, answer);
        return ray;
    }

    template <typename Thing> std::span<const Thing> atMost(std::size_t most, const std::vector<Thing>& things)
    {
        return std::span(things).first(std::min(most, things.size()));
    }

    // Puts both drawings into words.
    class Describer {
    public:
        Describer(const Question& question, const std::string& file, const worker::DebugRay& solution)
            : m_file(file)
            , m_solution(solution)
        {
            auto [scene, config] = files::loadSceneFile(
                std::filesystem::path(submission::sourceDirectory) / "scenes" / (question.scene + ".toml"));
            for (const auto& [name, value] : question.settings)
                files::setFeature(config.features, name, value);
            m_lights = std::move(scene.lights);
            for (const Scene::SceneLight& light : m_lights)
                m_numLightSamples += std::holds_alternative<PointLight>(light) ? 1 : config.features.numShadowSamples;
        }

        // Where the submission has a renderRay of its own, nobody noted the hits: then they are the solution's.
        [[nodiscard]] std::vector<std::string> operator()(const worker::DebugRay& ray) const
        {
            constexpr std::size_t mostHits = 50, mostShapes = 2'000; // a path has seven and about a hundred
            const auto recorded = atMost(mostHits, ray.hits);
            const auto hits = recorded.empty() ? atMost(mostHits, m_solution.hits) : recorded;
            const auto own = drawnByFile(m_file, atMost(mostShapes, ray.shapes), hits, recorded);
            std::vector<std::string> lines = inWords({ hits, m_lights, own, hits.size() * m_numLightSamples });
            if (ray.shapes.size() > mostShapes || ray.numDropped > 0)
                lines.emplace_back("and more, which is not looked at");
            return lines;
        }

    private:
        std::string m_file;
        const worker::DebugRay& m_solution;
        std::vector<Scene::SceneLight> m_lights;
        std::size_t m_numLightSamples = 0; // at a surface
    };

    // In a line, what may be words of a submission.
    std::string inALine(const char* prefix, const std::exception& error)
    {
        constexpr std::size_t longest = 200;
        std::string text = harmless(fmt::format("{}{}", prefix, error.what()).substr(0, longest));
        std::ranges::replace(text, '\n', ' ');
        return text;
    }

    std::vector<std::string> describeSubmission(
        const Describer& describe, const Observed& observed, const worker::Message& question, const KeptMessages& known)
    {
        try {
            return describe(askSubmission(observed, question, known));
        } catch (const worker::ProbeError& error) {
            return { inALine("unknown: threw an exception: ", error) };
        } catch (const std::exception& error) {
            return { inALine("unknown: ", error) };
        }
    }

}

std::optional<Observation> observe(const Observed& observed, ExpectedAnswers& expected, const KeptMessages& known)
{
    const auto question = std::ranges::find(questions, observed.feature, &Question::feature);
    if (question == questions.end())
        return {};
    try {
        const worker::Message message = toMessage(*question);
        const worker::DebugRay solution = toRay(expected.answer(debugRay, message));
        const Describer describe { *question, observed.file, solution };
        return Observation { observed.feature, describeSubmission(describe, observed, message, known),
            describe(solution) };
    } catch (const std::exception& error) {
        return Observation { observed.feature, { "not looked at" }, { inALine("unknown: ", error) } };
    }
}

}
