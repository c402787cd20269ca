#pragma once
#include "files/obj_file.h"
#include <exception>
#include <vector>

namespace files {

// OBJ files that are read side by side, each once however often it is named.
class ObjFiles {
public:
    // The paths as often as each will be taken. What is wrong with a file is told when it is taken.
    ObjFiles(const std::vector<std::filesystem::path>& paths, values::Progress& progress);

    // Throws Error.
    [[nodiscard]] ObjFile take(const std::filesystem::path& path);

private:
    struct Entry {
        ObjFile file;
        std::exception_ptr error;
        int numTakers = 0;
    };

    std::map<std::filesystem::path, Entry> m_entries;
};

}
