#include "submission/compile.h"
#include "files/digest.h"
#include "files/text.h"
#include "submission/build_step.h"
#include "submission/cache.h"
#include "submission/includes.h"
#include "submission/log.h"
#include "submission/symbols.h"
#include "submission/toolchain.h"
#include "values/stopwatch.h"
#include <fstream>

namespace submission {
namespace {

    namespace fs = std::filesystem;

    using Words = std::vector<std::string>;

    Words with(Words words, std::initializer_list<std::string> more)
    {
        words.insert(words.end(), more);
        return words;
    }

    // In a folder: <stem>.cpp, <stem>.o, what the compiler said, what it read, and the names in the object. Returns
    // whether the same would come out again.
    bool compileIn(const fs::path& folder, const std::string& stem, const std::string& text)
    {
        const Toolchain& toolchain = Toolchain::get();
        std::ofstream(folder / (stem + ".cpp"), std::ios::binary) << text;
        std::vector<fs::path> readable = interfaceHeaders();
        readable.insert(readable.end(), toolchain.folders.begin(), toolchain.folders.end());
        const Words words
            = with(toolchain.compile, { "-MD", "-MF", stem + ".d", "-c", stem + ".cpp", "-o", stem + ".o" });
        const StepEnd compiled = run({ words, folder, "compile.log", readable });
        if (compiled != StepEnd::Succeeded) {
            fs::remove(folder / (stem + ".o"));
            return compiled == StepEnd::Failed;
        }
        const StepEnd listed
            = run({ with(toolchain.symbols, { stem + ".o" }), folder, "symbols.log", toolchain.folders });
        if (listed != StepEnd::Succeeded) // a list that is cut off hides names
            fs::remove(folder / (stem + ".o"));
        return listed != StepEnd::Stopped;
    }

    Part judge(const fs::path& folder, const std::string& stem)
    {
        const std::string log = files::readText(folder / "compile.log");
        if (const std::string header = firstForeignInclude(folder, stem + ".d"); !header.empty())
            return refused(stem + ".cpp includes " + header + ", which is not part of the interface");
        if (!fs::exists(folder / (stem + ".o")))
            return refused(compilerErrors(log));
        if (const std::string symbol = firstForeignSymbol(folder / "symbols.log"); !symbol.empty())
            return refused(stem + ".cpp uses " + symbol + ", which is not part of the interface");
        return { State::Built, "", linesWith({ "no previous declaration" }, log) };
    }

}

Object compile(const std::string& name, const std::string& text)
{
    const values::Stopwatch watch;
    const std::string stem = fs::path(name).filename().string();
    Object object;
    object.key = files::Digest().add(Toolchain::get().digest).add(name).add(text).hex();
    const fs::path folder = cached(object.key, [&](const fs::path& made) { return compileIn(made, stem, text); });
    object.file = folder / (stem + ".o");
    object.part = judge(folder, stem);
    object.seconds = watch.seconds();
    return object;
}

}
