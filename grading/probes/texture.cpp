#include "texture.h"
#include "grading/probes/numbered_texels.h"
#include "worker/probe.h"

namespace grading {
namespace {

    using Sample = glm::vec3 (*)(const Image&, const glm::vec2&);

    // texels, texture coordinates -> colours
    void sampleAll(worker::Call& call, Sample sample)
    {
        const Image image = toImage(call.input.read<NumberedTexels>());
        std::vector<glm::vec3> colors;
        for (const glm::vec2& texCoord : call.input.read<std::vector<glm::vec2>>())
            colors.push_back(sample(image, texCoord));
        call.output << colors;
    }

    const worker::Probe nearest("texture.nearest", [](worker::Call& call) { sampleAll(call, sampleTextureNearest); });
    const worker::Probe bilinear(
        "texture.bilinear", [](worker::Call& call) { sampleAll(call, sampleTextureBilinear); });

}
}
