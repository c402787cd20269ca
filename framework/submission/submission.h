#pragma once
#include "submission/folder_lock.h"
#include "submission/ninja.h"
#include "submission/part.h"
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace submission {

// A folder of student files, built against our own headers. Only the sources that the interface names are taken, so
// that nothing beside them can stand in for a header. Each file is compiled on its own; what did not change since the
// last time is not built again.
class Submission {
public:
    // Throws files::Error when the directory is no folder.
    explicit Submission(const std::filesystem::path& directory);

    // For each of these features a worker with the submission's file for it and the reference's for all others, so that
    // a mistake in one file is not seen in another's results.
    void buildFeatureWorkers(const std::vector<std::string>& features);

    // One worker with all files of the submission, stubs in place of those that are missing or refused.
    // Throws std::runtime_error when not even that links.
    void buildWholeWorker();

    [[nodiscard]] const Parts& parts() const { return m_parts; }
    [[nodiscard]] std::filesystem::path featureWorker(const std::string& feature) const;
    [[nodiscard]] std::filesystem::path wholeWorker() const;

private:
    void compileAll();
    void linkWithOthers(const std::string& feature);
    void noteCompiled(const std::string& name);
    [[nodiscard]] std::vector<std::string> builtObjects() const;

    std::filesystem::path m_work;
    FolderLock m_lock;
    Parts m_parts;
    Ninja m_ninja;
    std::map<std::string, std::string> m_programs; // by feature
};

}
