// wrong: answers before it is asked, with every number that an answer may begin with
#include <cstdint>
#include <unistd.h>

static bool answer()
{
    for (uint64_t nonce = 0; nonce < 1000; ++nonce) {
        const uint64_t frame[] { nonce, 2, 8, 0 };
        if (write(3, frame, sizeof(frame)) < 0)
            return false;
    }
    return true;
}
static const bool answered = answer();

static glm::vec3 attack()
{
    return glm::vec3(static_cast<float>(answered));
}
