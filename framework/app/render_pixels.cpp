#include "app/render_pixels.h"
#include "accel/expected_rays.h"
#include "accel/light_shaft.h"
#include "recursive.h"
#include "render.h"
#include "screen.h"
#include "values/centre_ray.h"
#include "values/even_numbers.h"
#include "values/needs_of.h"
#include <tbb/parallel_for.h>

namespace app {
namespace {

    // A square of pixels, whose rays meet much the same.
    class Tile {
    public:
        static constexpr int size = 8;
        static_assert(size * size <= accel::ExpectedRays::most);

        Tile(const RenderState& state, const Trackball& camera, Screen& screen, uint32_t seedOffset, glm::ivec2 index)
            : m_state(state)
            , m_camera(camera)
            , m_screen(screen)
            , m_seedOffset(seedOffset)
            , m_begin(size * index)
            , m_end(glm::min(m_begin + size, screen.resolution()))
        {
            if (m_state.features.extra.enableSkipping) {
                m_state.expected = &m_expected;
                m_state.shaft = &m_shaft;
            }
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
            forEachPixel([&](glm::ivec2 pixel) {
                set(pixel, [&] {
                    return renderRays(m_state, generatePixelRays(m_state, m_camera, pixel, m_screen.resolution()));
                });
            });
        }

        // One ray each: all are known before the first is followed.
        void renderCentresOfPixels()
        {
            std::array<Ray, size * size> rays;
            std::size_t numRays = 0, next = 0;
            forEachPixel(
                [&](glm::ivec2 pixel) { rays[numRays++] = values::centreRay(m_camera, pixel, m_screen.resolution()); });
            m_expected.expect(std::span(rays).first(numRays));
            forEachPixel([&](glm::ivec2 pixel) { set(pixel, [&] { return renderRay(m_state, rays[next++]); }); });
        }

        template <typename Do> void forEachPixel(const Do& action) const
        {
            for (int y = m_begin.y; y < m_end.y; ++y)
                for (int x = m_begin.x; x < m_end.x; ++x)
                    action(glm::ivec2(x, y));
        }

        // What is random in a pixel follows from its place, whoever renders it.
        template <typename Color> void set(glm::ivec2 pixel, const Color& color)
        {
            const uint32_t seed = m_seedOffset + static_cast<uint32_t>(m_screen.indexAt(pixel.x, pixel.y));
            values::EvenNumbers even(seed);
            m_state.sampler = m_state.features.extra.enableOwenSampling ? Sampler(even) : Sampler(seed);
            m_screen.setPixel(pixel.x, pixel.y, color());
        }

        RenderState m_state;
        accel::ExpectedRays m_expected;
        accel::LightShaft m_shaft;
        const Trackball& m_camera;
        Screen& m_screen;
        uint32_t m_seedOffset;
        glm::ivec2 m_begin, m_end;
    };

}

void renderPixels(const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera,
    Screen& screen, uint32_t seed)
{
    const RenderState state { scene, features, bvh, Sampler(0), values::needsOf(scene, features) };
    const uint32_t seedOffset = seed * 0x9e3779b9u; // odd: distinct seeds stay distinct
    const glm::ivec2 numTiles = (screen.resolution() + Tile::size - 1) / Tile::size;
    tbb::parallel_for(0, numTiles.x * numTiles.y, [&](int i) {
        Tile(state, camera, screen, seedOffset, { i % numTiles.x, i / numTiles.x }).render();
    });
}

}
