#include "texture.h"
#include "grading/stress/probes/answer_all.h"
#include "grading/stress/probes/lookup.h"
#include <map>
#include <utility>

namespace stress {
namespace {

    const Image& imageOf(const glm::ivec2& size)
    {
        static std::map<std::pair<int, int>, Image> images;
        const auto [it, isNew] = images.try_emplace({ size.x, size.y });
        if (isNew)
            it->second = grading::toImage(texelsOf(size));
        return it->second;
    }

    glm::vec3 nearestAt(const Lookup& lookup)
    {
        return sampleTextureNearest(imageOf(lookup.size), lookup.texCoord);
    }

    glm::vec3 bilinearAt(const Lookup& lookup)
    {
        return sampleTextureBilinear(imageOf(lookup.size), lookup.texCoord);
    }

    const worker::Probe nearest("stress.nearest", [](worker::Call& call) { answerAll<Lookup>(call, nearestAt); });
    const worker::Probe bilinear("stress.bilinear", [](worker::Call& call) { answerAll<Lookup>(call, bilinearAt); });
    const worker::Probe step("stress.bilinear_step", [](worker::Call& call) {
        answerAll<Step>(call, [](const Step& query) {
            return StepColors { bilinearAt(query.lookup), bilinearAt(next(query)) };
        });
    });

}
}
