// ./raywork render: renders a scene with a submission's code, in a process of its own.
#include "app/explain.h"
#include "app/number_pairs.h"
#include "app/render_goal.h"
#include "app/renderer.h"
#include "app/run_command.h"
#include "app/save_debug_ray.h"
#include "app/save_picture.h"
#include "debug/false_color.h"
#include "worker/adaptive_request.h"
#include "worker/debug_ray.h"
#include "worker/render_request.h"

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
    std::string error;
    std::string time;
    uint32_t samples = 0;
    bool stratified = false;
    uint32_t threads = 0;
    bool explain = false;
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
    cli.add_flag("--explain", options.explain,
        "Tell what the picture needs, what is left out and why, and count what is done; no picture is written");
    cli.add_option("--set", options.settings, "feature=value, such as shadows=false or shading_model=phong; repeatable")
        ->take_all();
    cli.add_option("--orbit", options.orbit,
        "Turn the camera by these degrees, X,Y, about what it looks at; a debug ray is still the scene's camera's");
    cli.add_option(
        "--debug-ray", options.debugRay, "Draw what the ray through this pixel does, X,Y from the bottom left");
    cli.add_option("--show", options.show,
        fmt::format(
            "What is measured of each pixel: {}; as false colours, but raw in .exr [color]", debug::quantityNames()));
    for (CLI::Option* goal : { cli.add_option("--error", options.error,
                                   "Take as many samples as it needs, where it needs them, until no pixel is believed "
                                   "to err by more, in (0, 1]: 1 is from black to white"),
             cli.add_option("--time", options.time, "Render as well as can be in so many seconds") })
        for (const char* other : { "--samples", "--stratified", "--debug-ray", "--show" })
            goal->excludes(cli.get_option(other));
    cli.footer("Exit codes: 0 done, 2 bad input, 70 the submission's code failed.");
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
    request.size = app::parseSize(options.size);
    if (!options.orbit.empty())
        request.orbit = app::parseNumbers("--orbit", options.orbit);
    request.numThreads = options.threads;
    request.wantsProgress = true;
    request.quantity = debug::quantityOf(options.show);
    return request;
}

void report(const Options& options, const fs::path& output, const worker::Rendering& rendering)
{
    fmt::print("{}: {} x {} pixels of {} with {} in {:.2f} s, {:.2f} million rays, {:.2f} million a second\n",
        output.string(), rendering.size.x, rendering.size.y, options.scene, options.with, rendering.seconds,
        static_cast<double>(rendering.numRays) * 1e-6,
        static_cast<double>(rendering.numRays) * 1e-6 / std::max(rendering.seconds, 1e-9));
}

void render(const Options& options, const fs::path& output)
{
    app::checkPictureName(output);
    const worker::RenderRequest request = makeRequest(options);
    auto rendering = app::Renderer(options.with).ask<worker::Rendering>("render.image", request);
    const debug::Range range = debug::rangeOf(request.quantity, rendering.pixels);
    if (output.extension() != ".exr")
        rendering.pixels = debug::falseColors(request.quantity, std::move(rendering.pixels), range);
    app::savePicture(output, rendering.size, rendering.pixels);
    report(options, output, rendering);
    if (debug::isNumber(request.quantity))
        fmt::print("{} from {:g} to {:g}\n", options.show, range.lowest, range.highest);
}

void reportBelief(const adaptive::Summary& summary, glm::ivec2 size)
{
    const double numPixels = static_cast<double>(size.x) * static_cast<double>(size.y);
    fmt::print("{:.1f} samples a pixel, {} to {}; its error is believed to be {:.2g}, of no pixel above {:.2g}\n",
        static_cast<double>(summary.numSamples) / numPixels, summary.fewestSamples, summary.mostSamples, summary.error,
        summary.largestError);
}

void renderToGoal(const Options& options, const fs::path& output)
{
    app::checkPictureName(output);
    const worker::AdaptiveRequest request { makeRequest(options), app::parseGoal(options.error, options.time) };
    const auto [rendering, summary]
        = app::Renderer(options.with).ask<worker::AdaptiveRendering>("render.adaptive", request);
    app::savePicture(output, rendering.size, rendering.pixels);
    report(options, output, rendering);
    reportBelief(summary, rendering.size);
}

void followRay(const Options& options, const fs::path& output)
{
    app::checkDebugRayName(output);
    const worker::DebugRayRequest request { makeRequest(options), app::parseNumbers("--debug-ray", options.debugRay) };
    app::Renderer renderer { options.with };
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
    if (options.explain)
        return app::explain(
            app::Renderer(options.with).ask<worker::Explanation>("render.explain", makeRequest(options)));
    const fs::path output = options.output.empty() ? fs::path(options.scene).stem().string() + ".png" : options.output;
    if (!options.error.empty() || !options.time.empty())
        renderToGoal(options, output);
    else if (options.debugRay.empty())
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
