// timed out: never answers, and takes no processor time for it
#include <unistd.h>

static glm::vec3 attack()
{
    for (;;)
        pause();
}
