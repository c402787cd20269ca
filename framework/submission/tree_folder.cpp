#include "submission/tree_folder.h"
#include "files/digest.h"
#include "submission/cache.h"
#include "submission/prune.h"

namespace submission {

std::filesystem::path treeFolder(const std::filesystem::path& submission)
{
    constexpr std::uintmax_t mostBytes = std::uintmax_t(4) << 30; // the trees of some forty million triangles
    const std::filesystem::path all = keptFolder() / "trees";
    std::error_code failed;
    const std::filesystem::path whose = std::filesystem::weakly_canonical(submission, failed);
    const std::filesystem::path folder = all / files::Digest().add(whose.string()).hex();
    if (failed || (!std::filesystem::create_directories(folder, failed) && failed))
        return {};
    pruneFiles(all, mostBytes);
    return folder;
}

}
