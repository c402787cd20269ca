#include "app/render_pixels.h"
#include "accel/expected_rays.h"
#include "recursive.h"
#include "render.h"
#include "screen.h"
#include "values/centre_ray.h"
#include "values/even_numbers.h"
#include "values/needs_of.h"
#include <tbb/parallel_for.h>

namespace app {
namespace {

    class Row {
    public:
        Row(const RenderState& state, const Trackball& camera, Screen& screen, uint32_t seedOffset, int y)
            : m_state(state)
            , m_camera(camera)
            , m_screen(screen)
            , m_seedOffset(seedOffset)
            , m_y(y)
        {
            if (m_state.features.extra.enableSkipping)
                m_state.expected = &m_expected;
        }

        void render()
        {
            if (m_state.needs.pixelRays)
                renderRaysOfPixels();
            else
                renderCentresOfPixels();
        }

    private:
        void renderRaysOfPixels()
        {
            const glm::ivec2 resolution = m_screen.resolution();
            for (int x = 0; x < resolution.x; ++x)
                set(x, [&] {
                    return renderRays(m_state, generatePixelRays(m_state, m_camera, { x, m_y }, resolution));
                });
        }

        // One ray each: those of some neighbours are known before the first is followed.
        void renderCentresOfPixels()
        {
            constexpr int few = accel::ExpectedRays::most;
            std::array<Ray, few> rays;
            for (int first = 0; first < m_screen.resolution().x; first += few) {
                const int end = std::min(first + few, m_screen.resolution().x);
                for (int x = first; x < end; ++x)
                    rays[x - first] = values::centreRay(m_camera, { x, m_y }, m_screen.resolution());
                m_expected.expect(std::span(rays).first(end - first));
                for (int x = first; x < end; ++x)
                    set(x, [&] { return renderRay(m_state, rays[x - first]); });
            }
        }

        // What is random in a pixel follows from its place, whoever renders it.
        template <typename Color> void set(int x, const Color& color)
        {
            const uint32_t seed = m_seedOffset + static_cast<uint32_t>(m_screen.indexAt(x, m_y));
            values::EvenNumbers even(seed);
            m_state.sampler = m_state.features.extra.enableOwenSampling ? Sampler(even) : Sampler(seed);
            m_screen.setPixel(x, m_y, color());
        }

        RenderState m_state;
        accel::ExpectedRays m_expected;
        const Trackball& m_camera;
        Screen& m_screen;
        uint32_t m_seedOffset;
        int m_y;
    };

}

void renderPixels(const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera,
    Screen& screen, uint32_t seed)
{
    const RenderState state { scene, features, bvh, Sampler(0), values::needsOf(scene, features) };
    const uint32_t seedOffset = seed * 0x9e3779b9u; // odd: distinct seeds stay distinct
    tbb::parallel_for(0, screen.resolution().y, [&](int y) { Row(state, camera, screen, seedOffset, y).render(); });
}

}
