// wrong: announces an answer larger than any memory
#include <cstdint>
#include <unistd.h>

static glm::vec3 attack()
{
    const uint64_t frame[] { 1, 2, ~uint64_t(0) };
    (void)!write(3, frame, sizeof(frame));
    pause();
    return glm::vec3(1.0f);
}
