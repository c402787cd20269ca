// wrong: is right as long as it may be looked at, and careless afterwards
static glm::vec3 attack()
{
    static int calls = 0;
    return glm::vec3(calls++ == 0 ? 0.5f : 0.0f);
}
