// crashed: takes a hundred gigabytes
#include <vector>

static glm::vec3 attack()
{
    std::vector<std::vector<char>> taken;
    while (taken.size() < 100)
        taken.emplace_back(std::size_t(1) << 30, 'x');
    return glm::vec3(static_cast<float>(taken[99][0]));
}
