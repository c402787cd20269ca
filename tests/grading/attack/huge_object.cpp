// refused: fills the disk with an object of two gigabytes
asm(".data\n .skip 2000000000, 1\n .text");

static glm::vec3 attack()
{
    return glm::vec3(1.0f);
}
