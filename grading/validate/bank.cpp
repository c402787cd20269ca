#include "grading/validate/bank.h"
#include "files/error.h"
#include "files/table_reader.h"
#include "files/text.h"
#include "grading/feature.h"
#include "grading/validate/folder.h"
#include "grading/validate/replacement.h"
#include "submission/features.h"
#include <algorithm>
#include <fmt/format.h>

namespace grading {
namespace {

    namespace fs = std::filesystem;

    std::string textOf(files::TableReader& table, const std::string& file)
    {
        const files::TomlValue* replacements = table.find("replace");
        std::string whole;
        if (table.read("file", whole) == (replacements != nullptr))
            table.fail(table.line(),
                fmt::format("found {} replace and file, expected one of the two", replacements ? "both" : "neither"));
        if (!replacements) {
            const fs::path path = table.path().parent_path() / whole;
            if (!fs::is_regular_file(path))
                table.failFound(*table.find("file"), "a file in " + path.parent_path().string());
            return files::readText(path);
        }
        const std::string original = files::readText(referenceSource(file));
        const std::string text = replaced(table, *replacements, file, original);
        if (text == original)
            table.fail(replacements->line, "found no change, expected one");
        return text;
    }

    std::set<std::string> costsOf(files::TableReader& table)
    {
        std::set<std::string> costs;
        const files::TomlValue* value = table.find("costs");
        if (!value)
            table.fail(table.line(), "found no costs, expected the features that lose points");
        for (const files::TomlValue& element : table.arrayOf(*value, "an array of features")) {
            const std::string* feature = std::get_if<std::string>(&element.content);
            if (feature == nullptr
                || std::ranges::find(gradedFeatures, *feature, &Feature::name) == gradedFeatures.end())
                table.failFound(element, "a feature that is graded");
            costs.insert(*feature);
        }
        if (costs.empty())
            table.failFound(*value, "at least one feature");
        return costs;
    }

    bool isFeatureOf(const std::string& name, const std::string& file)
    {
        return std::ranges::any_of(
            gradedFeatures, [&](const Feature& feature) { return feature.name == name && feature.file == file; });
    }

    Solution readSolution(files::TableReader table, const std::string& file, bool isWrong)
    {
        Solution solution { file, "", {}, "" };
        table.require("name", solution.name);
        if (isWrong) {
            solution.costs = costsOf(table);
            const bool elsewhere = std::ranges::any_of(
                solution.costs, [&](const std::string& feature) { return !isFeatureOf(feature, file); });
            std::string why;
            if (!table.read("why", why) && elsewhere)
                table.fail(table.line(), "found no why, expected one since another file's feature loses points too");
        }
        solution.text = textOf(table, file);
        table.finish();
        return solution;
    }

    // Of wrong/ or accepted/, whose tables have the folder's name.
    std::vector<Solution> loadKind(const fs::path& bank, const std::string& kind)
    {
        std::vector<Solution> solutions;
        for (const std::string& file : submission::features) {
            const fs::path path = bank / kind / (file + ".toml");
            if (!fs::exists(path))
                continue;
            const files::TomlValue document = files::loadToml(path);
            files::TableReader reader { path, document };
            std::set<std::string> names;
            for (files::TableReader& table : reader.readTables(kind)) {
                solutions.push_back(readSolution(table, file, kind == "wrong"));
                if (!names.insert(solutions.back().name).second)
                    table.fail(table.line(), "found the name \"" + solutions.back().name + "\" twice");
            }
            reader.finish();
        }
        return solutions;
    }

    // A misspelt name must not silently leave out a file.
    void requireKnownFiles(const fs::path& folder)
    {
        if (!fs::is_directory(folder))
            return;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            const std::string stem = entry.path().stem().string();
            if (entry.path().extension() == ".toml"
                && std::ranges::find(submission::features, stem) == submission::features.end())
                throw files::Error(entry.path(), "found no file of that name in the reference");
        }
    }

}

Bank loadBank(const fs::path& folder)
{
    for (const char* kind : { "wrong", "accepted" })
        requireKnownFiles(folder / kind);
    Bank bank { loadKind(folder, "wrong"), loadKind(folder, "accepted") };
    if (bank.wrong.empty() && bank.accepted.empty())
        throw files::Error(folder, "found no solutions, expected wrong/<file>.toml and accepted/<file>.toml");
    return bank;
}

}
