// refused: has the compiler read a file without an end
#include "/dev/zero"

static glm::vec3 attack()
{
    return glm::vec3(1.0f);
}
