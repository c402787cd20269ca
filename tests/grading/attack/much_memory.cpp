// crashed: takes a hundred gigabytes
#include <vector>

static glm::vec3 attack()
{
    std::vector<char*> taken;
    while (taken.size() < 100) {
        taken.push_back(new char[std::size_t(1) << 30]);
        taken.back()[0] = 'x';
    }
    return glm::vec3(static_cast<float>(taken[99][0]));
}
