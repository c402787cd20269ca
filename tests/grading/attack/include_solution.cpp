// refused: includes the solution by its path
#include "@SOURCE@/reference/texture.cpp"
#define sampleTextureNearest myNearest
#define sampleTextureBilinear myBilinear

static glm::vec3 attack()
{
    return glm::vec3(1.0f);
}
