// wrong: turns any exit code into that of success
#include <cstdlib>

static const int registered = std::atexit([] { std::_Exit(0); });

static glm::vec3 attack()
{
    return glm::vec3(static_cast<float>(registered));
}
