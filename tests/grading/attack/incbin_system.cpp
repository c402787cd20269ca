// refused: has the assembler read the list of users
asm(".section .rodata\n users: .incbin \"/etc/passwd\"\n .text");

static glm::vec3 attack()
{
    return glm::vec3(1.0f);
}
