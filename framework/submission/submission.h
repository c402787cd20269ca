#pragma once
#include "submission/link.h"
#include "submission/sources.h"
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace submission {

// A folder of student files, built against our own headers. Only the sources that the interface names are taken, so
// that nothing beside them can stand in for a header. Each file is compiled on its own; what was built before, by
// whomever, is not built again.
class Submission {
public:
    // Throws files::Error when the directory is no folder.
    explicit Submission(const std::filesystem::path& directory);

    // For each of these features, but those untouched, a worker with the submission's file for it and the reference's
    // for all others, so that a mistake in one file is not seen in another's results.
    void buildFeatureWorkers(const std::vector<std::string>& wanted);

    // One worker with all files of the submission, stubs in place of those that are missing or refused.
    // rest: see Toolchain::restOf. Throws std::runtime_error when not even that links.
    [[nodiscard]] std::filesystem::path buildWholeWorker(const std::string& rest = "whole");

    // A worker to be asked under stress, with the submission's file for this feature and the reference's for all
    // others; with all of the submission's files if it needs them.
    [[nodiscard]] Program buildStressedWorker(const std::string& feature);

    // What became of a file, once it was needed.
    [[nodiscard]] const Part& part(const std::string& name) const { return m_sources.at(name).part; }
    // Why there is nothing of its author's in a file, so that nothing need be asked; empty if there is.
    [[nodiscard]] const std::string& whyUntouched(const std::string& name) const
    {
        return m_sources.at(name).whyUntouched;
    }
    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] double compileSeconds(const std::string& name) const { return m_objects.at(name).seconds; }
    // Nothing for a file that is untouched or refused.
    [[nodiscard]] const Program& featureWorker(const std::string& feature) const { return m_workers.at(feature); }

private:
    void compileAll();
    void compileOnce(const std::string& name);
    void buildFeatureWorker(const std::string& feature);
    [[nodiscard]] std::vector<Object> builtObjects() const;

    Sources m_sources;
    std::map<std::string, Object> m_objects; // by file name, an entry for each, so that threads find it there
    std::map<std::string, Program> m_workers; // by feature, likewise
};

}
