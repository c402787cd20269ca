// timed out: never even starts
static bool wait()
{
    for (volatile bool forever = true; forever;) { }
    return true;
}
static const bool waited = wait();

static glm::vec3 attack()
{
    return glm::vec3(static_cast<float>(waited));
}
