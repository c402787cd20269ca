#include "extra.h"

glm::vec3 sampleEnvironmentMap(RenderState&, Ray)
{
    return glm::vec3(0.0f);
}
