// timed out: never answers
static glm::vec3 attack()
{
    for (volatile bool forever = true; forever;) { }
    return glm::vec3(1.0f);
}
