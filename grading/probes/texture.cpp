#include "texture.h"
#include "worker/probe.h"
#include "worker/scene_message.h"

namespace grading {
namespace {

    using Sample = glm::vec3 (*)(const Image&, const glm::vec2&);

    // image, texture coordinates -> colours
    void sampleAll(worker::Call& call, Sample sample)
    {
        const auto image = call.input.read<Image>();
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
