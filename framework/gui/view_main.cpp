// ./raywork view: a window in which a submission's code traces a scene.
#include "app/run_command.h"
#include "gui/application.h"
#include "gui/layout_file.h"
#include "gui/window.h"
#include "submission/named_folder.h"
#include "submission/paths.h"

namespace {

namespace fs = std::filesystem;

struct Options {
    std::string scene = (fs::path(submission::sourceDirectory) / "scenes" / "cornell_box.toml").string();
    std::string with = "reference";
};

void show(const Options& options)
{
    gui::Window window { "Raywork", { 1280, 720 }, gui::layoutFile() };
    gui::Application application { options.scene, submission::namedFolder(options.with) };
    while (!window.shouldClose()) {
        window.beginFrame();
        application.frame(window);
        window.drawFrame();
        window.showFrame();
    }
}

int run(const Options& options)
{
    try {
        show(options);
        return app::Success;
    } catch (const gui::NoWindow& error) {
        fmt::print(stderr, "{}\n", error.what());
        return app::Unavailable;
    }
}

}

int main(int argc, char** argv)
{
    CLI::App cli { "Shows a scene in a window, traced by a submission's code.", "./raywork view" };
    Options options;
    cli.add_option("scene", options.scene, "A scene (.toml) or a mesh (.obj) [scenes/cornell_box.toml]");
    cli.add_option("--with", options.with, "Whose code: student, reference, or a submission's folder [reference]");
    cli.footer("Exit codes: 0 closed, 2 bad input, 69 no window can be opened.");
    return app::runCommand(cli, argc, argv, [&] { return run(options); });
}
