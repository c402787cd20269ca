// crashed: calls itself until the stack is used up
static float recurse(volatile const float* above)
{
    volatile float here[256] { above[0] };
    return recurse(here) + here[0];
}

static glm::vec3 attack()
{
    const volatile float top = 1.0f;
    return glm::vec3(recurse(&top));
}
