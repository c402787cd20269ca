// wrong: starts processes that start processes; a bounded number, for the machine's sake
#include <unistd.h>

static bool explode()
{
    for (int i = 0; i < 10; ++i)
        if (fork() == 0)
            for (int j = 0; j < 10; ++j)
                if (fork() == 0)
                    pause();
    return true;
}

static glm::vec3 attack()
{
    static const bool done = explode();
    return glm::vec3(static_cast<float>(done));
}
