#include "grading/validate/folder.h"
#include "files/error.h"
#include "submission/features.h"
#include "submission/paths.h"
#include <fstream>
#include <unistd.h>

namespace grading {
namespace {

    namespace fs = std::filesystem;

    const fs::path reference = fs::path(submission::sourceDirectory) / "reference";

}

fs::path validationFolder()
{
    return fs::path(submission::buildDirectory) / "validate" / std::to_string(getpid());
}

fs::path referenceSource(const std::string& file)
{
    return reference / (file + ".cpp");
}

void writeSource(const fs::path& path, const std::string& text)
{
    fs::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file)
        throw files::Error(path, "cannot be written");
}

void writeChangedReference(const fs::path& folder, const std::string& file, const std::string& text)
{
    fs::create_directories(folder);
    for (const std::string& feature : submission::features)
        fs::copy_file(referenceSource(feature), folder / (feature + ".cpp"), fs::copy_options::overwrite_existing);
    writeSource(folder / (file + ".cpp"), text);
}

}
