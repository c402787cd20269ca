// crashed: asks somebody else for the answer
#include <stdexcept>
#include <sys/socket.h>

static glm::vec3 attack()
{
    if (socket(AF_INET, SOCK_STREAM, 0) >= 0 || socket(AF_UNIX, SOCK_STREAM, 0) >= 0)
        throw std::runtime_error("found a way out");
    throw std::runtime_error("found nothing");
}
