// crashed: starts threads until there is no memory for more
#include <thread>
#include <unistd.h>

static glm::vec3 attack()
{
    for (;;)
        std::thread([] { pause(); }).detach();
}
