#include "debug/recording.h"
#include "debug/tally.h"
#include "provided/marks.h"
#include "shading.h"
#include "texture.h"

const char provided::colorMark = 0;

glm::vec3 sampleMaterialKd(RenderState& state, const HitInfo& hitInfo)
{
    const Image* texture = hitInfo.material.kdTexture;
    if (!state.features.enableTextureMapping || !texture)
        return hitInfo.material.kd;
    debug::Tally::addLookup();
    if (debug::Recording::isOpen()) [[unlikely]]
        debug::Recording::addLookup(*texture, hitInfo.texCoord);
    return state.features.enableBilinearTextureFiltering ? sampleTextureBilinear(*texture, hitInfo.texCoord)
                                                         : sampleTextureNearest(*texture, hitInfo.texCoord);
}
