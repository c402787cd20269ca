#include "bench/clock.h"
#include "bench/rival.h"
#ifdef RAYWORK_EMBREE
#include <embree3/rtcore.h>

namespace bench {
namespace {

    struct Settings {
        const char* name;
        RTCBuildQuality quality;
        RTCSceneFlags flags;
    };

    class EmbreeRival : public Rival {
    public:
        EmbreeRival(std::span<const Triangle> triangles, const Settings& settings)
            : m_device(rtcNewDevice(nullptr))
        {
            name = settings.name;
            rtcSetDeviceMemoryMonitorFunction(m_device, countBytes, this);
            buildSeconds = std::min(build(triangles, settings), build(triangles, settings));
            rtcInitIntersectContext(&m_context);
        }

        ~EmbreeRival() override
        {
            rtcReleaseScene(m_scene);
            rtcReleaseDevice(m_device);
        }

        void load(std::span<const Ray> rays) override
        {
            m_rays.resize(rays.size());
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const auto& [o, d, t] = rays[i];
                m_rays[i].ray = { o.x, o.y, o.z, 0.0f, d.x, d.y, d.z, 0.0f, t, ~0u, 0, 0 };
                m_rays[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
            }
        }

        double traceClosest() override
        {
            return secondsOf([&] {
                for (RTCRayHit& ray : m_rays)
                    rtcIntersect1(m_scene, &m_context, &ray);
            });
        }

        double traceOccluded() override
        {
            return secondsOf([&] {
                for (RTCRayHit& ray : m_rays)
                    rtcOccluded1(m_scene, &m_context, &ray.ray);
            });
        }

        [[nodiscard]] float distance(std::size_t ray) const override
        {
            const bool isHit = m_rays[ray].hit.geomID != RTC_INVALID_GEOMETRY_ID;
            return isHit ? m_rays[ray].ray.tfar : std::numeric_limits<float>::infinity();
        }

        [[nodiscard]] bool isOccluded(std::size_t ray) const override { return m_rays[ray].ray.tfar < 0.0f; }

    private:
        // Returns the seconds that it takes.
        double build(std::span<const Triangle> triangles, const Settings& settings)
        {
            if (m_scene)
                rtcReleaseScene(m_scene);
            m_scene = rtcNewScene(m_device);
            rtcSetSceneFlags(m_scene, settings.flags);
            rtcSetSceneBuildQuality(m_scene, settings.quality);
            attach(triangles, settings.quality);
            return secondsOf([&] { rtcCommitScene(m_scene); });
        }

        void attach(std::span<const Triangle> triangles, RTCBuildQuality quality)
        {
            const RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
            auto* positions = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
                geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * triangles.size()));
            std::copy(triangles.begin(), triangles.end(), positions);
            auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
                geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
            for (unsigned i = 0; i < 3 * triangles.size(); ++i)
                indices[i] = i;
            rtcSetGeometryBuildQuality(geometry, quality);
            rtcCommitGeometry(geometry);
            rtcAttachGeometry(m_scene, geometry);
            rtcReleaseGeometry(geometry);
        }

        static bool countBytes(void* rival, ssize_t bytes, bool)
        {
            static_cast<EmbreeRival*>(rival)->numBytes += static_cast<std::size_t>(bytes);
            return true;
        }

        RTCDevice m_device;
        RTCScene m_scene = nullptr;
        RTCIntersectContext m_context;
        std::vector<RTCRayHit> m_rays;
    };

}

void addEmbree(std::span<const Triangle> triangles, Rivals& rivals)
{
    for (const Settings& settings : {
             Settings { "Embree default", RTC_BUILD_QUALITY_MEDIUM, RTC_SCENE_FLAG_NONE },
             Settings { "Embree high", RTC_BUILD_QUALITY_HIGH, RTC_SCENE_FLAG_NONE },
             Settings { "Embree robust", RTC_BUILD_QUALITY_MEDIUM, RTC_SCENE_FLAG_ROBUST },
         })
        rivals.push_back(std::make_unique<EmbreeRival>(triangles, settings));
}

}
#else

void bench::addEmbree(std::span<const Triangle>, Rivals&) { }

#endif
