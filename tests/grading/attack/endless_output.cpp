// timed out: prints without end
#include <cstdio>

static glm::vec3 attack()
{
    for (;;)
        std::puts("100 / 100");
}
