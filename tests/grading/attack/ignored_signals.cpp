// timed out: will not be told that its time is over
#include <csignal>

static glm::vec3 attack()
{
    for (int signal = 1; signal < 32; ++signal)
        std::signal(signal, SIG_IGN);
    for (volatile bool forever = true; forever;) { }
    return glm::vec3(1.0f);
}
