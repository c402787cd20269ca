#include "files/obj_files.h"
#include <tbb/parallel_for_each.h>

namespace files {

ObjFiles::ObjFiles(const std::vector<std::filesystem::path>& paths, values::Progress& progress)
{
    for (const std::filesystem::path& path : paths)
        ++m_entries[path].numTakers;
    tbb::parallel_for_each(m_entries, [&](auto& named) {
        auto& [path, entry] = named;
        try {
            entry.file = readObjFile(path, progress);
        } catch (...) {
            entry.error = std::current_exception();
        }
    });
}

ObjFile ObjFiles::take(const std::filesystem::path& path)
{
    Entry& entry = m_entries.at(path);
    if (entry.error)
        std::rethrow_exception(entry.error);
    return --entry.numTakers == 0 ? std::move(entry.file) : entry.file;
}

}
