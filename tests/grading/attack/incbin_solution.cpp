// refused: has the assembler read the solution
asm(".section .rodata\n solution: .incbin \"@SOURCE@/reference/texture.cpp\"\n .text");

static glm::vec3 attack()
{
    return glm::vec3(1.0f);
}
