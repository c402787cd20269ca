// ./raywork render: renders a scene with a submission's code, in a process of its own.
#include "app/progress_bar.h"
#include "app/save_picture.h"
#include "submission/paths.h"
#include "submission/submission.h"
#include "worker/process.h"
#include "worker/render_request.h"
#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace {

namespace fs = std::filesystem;

enum ExitCode { Success = 0, BadInput = 2, SubmissionFailed = 70 };

struct Options {
    std::string scene;
    std::string output;
    std::string with = "reference";
    std::string size;
    uint32_t samples = 0;
    bool stratified = false;
    uint32_t threads = 0;
    std::vector<std::string> settings;
};

void declare(CLI::App& cli, Options& options)
{
    cli.add_option("scene", options.scene, "A scene (.toml) or a mesh (.obj)")->required();
    cli.add_option("-o,--output", options.output, "The picture, .png or .exr [the scene's name, .png]");
    cli.add_option("--with", options.with, "Whose code: student, reference, or a submission's folder [reference]");
    cli.add_option("--size", options.size, "Pixels, as WIDTHxHEIGHT [what the scene says]");
    cli.add_option("--samples", options.samples, "Rays a pixel [what the scene says]")->check(CLI::PositiveNumber);
    cli.add_flag("--stratified", options.stratified, "One ray in each cell of the pixel, rather than anywhere");
    cli.add_option("--threads", options.threads, "Threads [one a core]")->check(CLI::PositiveNumber);
    cli.add_option("--set", options.settings, "feature=value, such as shadows=false or shading_model=phong; repeatable")
        ->take_all();
    cli.footer("Exit codes: 0 done, 2 bad input, 70 the submission's code failed.");
}

fs::path submissionFolder(const std::string& with)
{
    if (with == "student" || with == "reference")
        return fs::path(submission::sourceDirectory) / with;
    return with;
}

glm::ivec2 parseSize(const std::string& text)
{
    glm::ivec2 size { 0 };
    char rest = 0;
    if (text.empty())
        return size;
    constexpr int largest = 32768;
    const bool isSize = std::sscanf(text.c_str(), "%dx%d%c", &size.x, &size.y, &rest) == 2;
    if (!isSize || size.x < 1 || size.y < 1 || size.x > largest || size.y > largest)
        throw std::invalid_argument(
            fmt::format("--size: found '{}', expected WIDTHxHEIGHT, each 1 to {}", text, largest));
    return size;
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
    request.numThreads = options.threads;
    request.wantsProgress = true;
    return request;
}

worker::Rendering render(const fs::path& program, const worker::RenderRequest& request)
{
    constexpr std::chrono::hours patience { 24 * 365 }; // whoever waits can interrupt
    worker::Limits limits;
    limits.captureOutput = false;
    limits.answerBytes = std::size_t(16) << 30; // a picture of 32768 x 32768 pixels has 12 GiB
    limits.readable = { "/" }; // a scene names its meshes and textures wherever they lie
    worker::Process process { program, limits };
    worker::Message input;
    input << request;
    const worker::Answer answer = process.ask("render.image", input, patience, app::drawProgressBar);
    app::clearProgressBar();
    worker::Reader reader { answer.output };
    return reader.read<worker::Rendering>();
}

void report(const Options& options, const fs::path& output, const worker::Rendering& rendering)
{
    fmt::print("{}: {} x {} pixels of {} with {} in {:.2f} s, {:.2f} million rays, {:.2f} million a second\n",
        output.string(), rendering.size.x, rendering.size.y, options.scene, options.with, rendering.seconds,
        static_cast<double>(rendering.numRays) * 1e-6,
        static_cast<double>(rendering.numRays) * 1e-6 / std::max(rendering.seconds, 1e-9));
}

void run(const Options& options)
{
    const fs::path output = options.output.empty() ? fs::path(options.scene).stem().string() + ".png" : options.output;
    app::checkPictureName(output);
    const worker::RenderRequest request = makeRequest(options);

    submission::Submission submission { submissionFolder(options.with) };
    const fs::path worker = submission.buildWholeWorker();
    for (const std::string& name : submission.names())
        if (const submission::Part& part = submission.part(name); part.state == submission::State::Refused)
            fmt::print(stderr, "{}.cpp is left out. {}", name, part.message);

    const worker::Rendering rendering = render(worker, request);
    app::savePicture(output, rendering.size, rendering.pixels);
    report(options, output, rendering);
}

}

int main(int argc, char** argv)
{
    CLI::App cli { "Renders a scene.", "./raywork render" };
    Options options;
    declare(cli, options);
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return cli.exit(error) == 0 ? Success : BadInput;
    }
    try {
        run(options);
        return Success;
    } catch (const worker::Failure& failure) {
        app::clearProgressBar();
        fmt::print(stderr, "the code of {} failed: {}\n", options.with, failure.what());
        return SubmissionFailed;
    } catch (const app::PictureNotSaved&) {
        return BadInput;
    } catch (const std::exception& error) {
        app::clearProgressBar();
        fmt::print(stderr, "{}\n", error.what());
        return BadInput;
    }
}
