// crashed: hangs up
#include <unistd.h>

static glm::vec3 attack()
{
    for (int file = 0; file < 100; ++file)
        close(file);
    return glm::vec3(1.0f);
}
