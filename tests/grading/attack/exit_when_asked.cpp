// crashed: ends the process with the exit code of success when asked
#include <cstdlib>

static glm::vec3 attack()
{
    std::_Exit(0);
}
