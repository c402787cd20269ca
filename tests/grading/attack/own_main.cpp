// refused: takes the place of the worker
int main()
{
    return 0;
}

static glm::vec3 attack()
{
    return glm::vec3(1.0f);
}
