// ./raywork render: renders a scene with a submission's code, in a process of its own.
#include "app/progress_bar.h"
#include "app/run_command.h"
#include "app/save_debug_ray.h"
#include "app/save_picture.h"
#include "debug/false_color.h"
#include "submission/named_folder.h"
#include "submission/submission.h"
#include "worker/debug_ray.h"
#include "worker/process.h"
#include <optional>

namespace {

namespace fs = std::filesystem;

struct Options {
    std::string scene;
    std::string output;
    std::string with = "reference";
    std::string size;
    std::string orbit;
    std::string debugRay;
    std::string show = "color";
    uint32_t samples = 0;
    bool stratified = false;
    uint32_t threads = 0;
    std::vector<std::string> settings;
};

void declare(CLI::App& cli, Options& options)
{
    cli.add_option("scene", options.scene, "A scene (.toml) or a mesh (.obj)")->required();
    cli.add_option("-o,--output", options.output,
        "The picture, .png or .exr, of a debug ray also .svg or .json [the scene's name, .png]");
    cli.add_option("--with", options.with, "Whose code: student, reference, or a submission's folder [reference]");
    cli.add_option("--size", options.size, "Pixels, as WIDTHxHEIGHT [what the scene says]");
    cli.add_option("--samples", options.samples, "Rays a pixel [what the scene says]")->check(CLI::PositiveNumber);
    cli.add_flag("--stratified", options.stratified, "One ray in each cell of the pixel, rather than anywhere");
    cli.add_option("--threads", options.threads, "Threads [one a core]")->check(CLI::PositiveNumber);
    cli.add_option("--set", options.settings, "feature=value, such as shadows=false or shading_model=phong; repeatable")
        ->take_all();
    cli.add_option("--orbit", options.orbit,
        "Turn the camera by these degrees, X,Y, about what it looks at; a debug ray is still the scene's camera's");
    cli.add_option(
        "--debug-ray", options.debugRay, "Draw what the ray through this pixel does, X,Y from the bottom left");
    cli.add_option("--show", options.show,
        fmt::format(
            "What is measured of each pixel: {}; as false colours, but raw in .exr [color]", debug::quantityNames()));
    cli.footer("Exit codes: 0 done, 2 bad input, 70 the submission's code failed.");
}

// Two numbers with a character between them.
std::optional<glm::ivec2> parsePair(const std::string& text, char between)
{
    glm::ivec2 pair { 0 };
    char found = 0, rest = 0;
    const bool isPair = std::sscanf(text.c_str(), "%d%c%d%c", &pair.x, &found, &pair.y, &rest) == 3;
    return isPair && found == between ? std::optional(pair) : std::nullopt;
}

glm::ivec2 parseSize(const std::string& text)
{
    constexpr int largest = 32768;
    if (text.empty())
        return glm::ivec2(0);
    const auto size = parsePair(text, 'x');
    if (!size || std::min(size->x, size->y) < 1 || std::max(size->x, size->y) > largest)
        throw std::invalid_argument(
            fmt::format("--size: found '{}', expected WIDTHxHEIGHT, each 1 to {}", text, largest));
    return *size;
}

glm::ivec2 parseNumbers(const std::string& option, const std::string& text)
{
    const auto numbers = parsePair(text, ',');
    if (!numbers)
        throw std::invalid_argument(fmt::format("{}: found '{}', expected X,Y", option, text));
    return *numbers;
}

worker::RenderRequest makeRequest(const Options& options)
{
    worker::RenderRequest request;
    request.scene = fs::absolute(options.scene).string();
    request.settings = options.settings;
    if (options.samples > 0)
        request.settings.push_back(fmt::format("pixel_samples={}", options.samples));
    if (options.stratified)
        request.settings.emplace_back("jittered_sampling=true");
    request.size = parseSize(options.size);
    if (!options.orbit.empty())
        request.orbit = parseNumbers("--orbit", options.orbit);
    request.numThreads = options.threads;
    request.wantsProgress = true;
    request.quantity = debug::quantityOf(options.show);
    return request;
}

// The submission's worker, which reads a scene's meshes and textures wherever they lie.
class Renderer {
public:
    explicit Renderer(const fs::path& program)
        : m_process(program, limits())
    {
    }

    // Result: what the probe answers.
    template <typename Result, typename Request> Result ask(const std::string& probe, const Request& request)
    {
        constexpr std::chrono::hours patience { 24 * 365 }; // whoever waits can interrupt
        worker::Message input;
        input << request;
        const struct Bar {
            ~Bar() { app::clearProgressBar(); } // also before what went wrong is told
        } bar;
        const worker::Answer answer = m_process.ask(probe, input, patience, app::drawProgressBar);
        worker::Reader reader { answer.output };
        return reader.read<Result>();
    }

private:
    static worker::Limits limits()
    {
        worker::Limits limits;
        limits.captureOutput = false;
        limits.answerBytes = std::size_t(16) << 30; // a picture of 32768 x 32768 pixels has 12 GiB
        limits.readable = { "/" };
        return limits;
    }

    worker::Process m_process;
};

void report(const Options& options, const fs::path& output, const worker::Rendering& rendering)
{
    fmt::print("{}: {} x {} pixels of {} with {} in {:.2f} s, {:.2f} million rays, {:.2f} million a second\n",
        output.string(), rendering.size.x, rendering.size.y, options.scene, options.with, rendering.seconds,
        static_cast<double>(rendering.numRays) * 1e-6,
        static_cast<double>(rendering.numRays) * 1e-6 / std::max(rendering.seconds, 1e-9));
}

fs::path build(const Options& options)
{
    submission::Submission submission { submission::namedFolder(options.with) };
    fs::path worker = submission.buildWholeWorker();
    for (const std::string& name : submission.names())
        if (const submission::Part& part = submission.part(name); part.state == submission::State::Refused)
            fmt::print(stderr, "{}.cpp is left out. {}", name, part.message);
    return worker;
}

void render(const Options& options, const fs::path& output)
{
    app::checkPictureName(output);
    const worker::RenderRequest request = makeRequest(options);
    auto rendering = Renderer(build(options)).ask<worker::Rendering>("render.image", request);
    const debug::Range range = debug::rangeOf(request.quantity, rendering.pixels);
    if (output.extension() != ".exr")
        rendering.pixels = debug::falseColors(request.quantity, std::move(rendering.pixels), range);
    app::savePicture(output, rendering.size, rendering.pixels);
    report(options, output, rendering);
    if (debug::isNumber(request.quantity))
        fmt::print("{} from {:g} to {:g}\n", options.show, range.lowest, range.highest);
}

void followRay(const Options& options, const fs::path& output)
{
    app::checkDebugRayName(output);
    const worker::DebugRayRequest request { makeRequest(options), parseNumbers("--debug-ray", options.debugRay) };
    Renderer renderer { build(options) };
    const auto ray = renderer.ask<worker::DebugRay>("debug.ray", request);
    auto picture = renderer.ask<worker::Rendering>("render.image", request.render);
    const debug::Range range = debug::rangeOf(request.render.quantity, picture.pixels);
    picture.pixels = debug::falseColors(request.render.quantity, std::move(picture.pixels), range);
    app::saveDebugRay(output, ray, picture);
    fmt::print("{}: {} shapes were drawn and {} textures looked up along the ray through pixel {},{} of {} with {}\n",
        output.string(), ray.shapes.size(), ray.lookups.size(), ray.pixel.x, ray.pixel.y, options.scene, options.with);
    if (ray.numDropped > 0)
        fmt::print("{} more were drawn than are kept\n", ray.numDropped);
}

void renderOrFollow(const Options& options)
{
    const fs::path output = options.output.empty() ? fs::path(options.scene).stem().string() + ".png" : options.output;
    if (options.debugRay.empty())
        render(options, output);
    else
        followRay(options, output);
}

int run(const Options& options)
{
    try {
        renderOrFollow(options);
        return app::Success;
    } catch (const worker::Failure& failure) {
        fmt::print(stderr, "the code of {} failed: {}\n", options.with, failure.what());
        return app::SubmissionFailed;
    } catch (const app::PictureNotSaved&) {
        return app::BadInput;
    }
}

}

int main(int argc, char** argv)
{
    CLI::App cli { "Renders a scene.", "./raywork render" };
    Options options;
    declare(cli, options);
    return app::runCommand(cli, argc, argv, [&] { return run(options); });
}
