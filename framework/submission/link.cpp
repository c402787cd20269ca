#include "submission/link.h"
#include "files/digest.h"
#include "files/text.h"
#include "submission/build_step.h"
#include "submission/cache.h"
#include "submission/log.h"
#include "submission/paths.h"
#include "submission/toolchain.h"
#include "values/stopwatch.h"

namespace submission {

namespace fs = std::filesystem;

static bool linkIn(const fs::path& folder, const std::vector<Object>& objects, const std::string& rest)
{
    const Toolchain& toolchain = Toolchain::get();
    std::vector<std::string> words = toolchain.link;
    words.insert(words.end(), { "-o", "worker" });
    for (const Object& object : objects)
        words.push_back(object.file.string());
    const std::vector<std::string> ours = toolchain.restOf(rest);
    words.insert(words.end(), ours.begin(), ours.end());
    std::vector<fs::path> readable = toolchain.folders;
    for (const Object& object : objects)
        readable.push_back(object.file);
    for (const std::string& word : ours)
        if (word.starts_with(buildDirectory))
            readable.emplace_back(word);
    const StepEnd end = run({ words, folder, "link.log", readable });
    if (end != StepEnd::Succeeded)
        fs::remove(folder / "worker");
    return end != StepEnd::Stopped;
}

Program link(const std::vector<Object>& objects, const std::string& rest)
{
    const values::Stopwatch watch;
    files::Digest digest;
    digest.add(Toolchain::get().digest).add("link").add(rest).add(Toolchain::get().digestOfRest(rest));
    for (const Object& object : objects)
        digest.add(object.key);
    Program program { digest.hex(), {}, "" };
    const fs::path folder = cached(program.key, [&](const fs::path& made) { return linkIn(made, objects, rest); });
    program.file = folder / "worker";
    if (!fs::exists(program.file))
        program.errors = linkerErrors(files::readText(folder / "link.log"));
    program.seconds = watch.seconds();
    return program;
}

}
