// crashed: becomes another program
#include <unistd.h>

static glm::vec3 attack()
{
    execl("/bin/sh", "sh", "-c", "echo 100 / 100; sleep 1000000 & exit 0", nullptr);
    _exit(0);
}
