#pragma once
#include <cstdint>

namespace debug {

// On whose way something is traced or drawn.
enum class Way : uint8_t { Path, Shadow }; // from the camera on, or from a surface to a light
struct Cause {
    int bounce = 0; // as deep as renderRay: 0 is the camera's ray
    Way way = Way::Path;

    [[nodiscard]] bool operator==(const Cause&) const = default;
};

// What this thread traces and draws while it lives has this cause. The innermost one counts.
class Because {
public:
    explicit Because(int bounce)
        : Because(Cause { bounce, Way::Path })
    {
    }
    explicit Because(Way way)
        : Because(Cause { s_now.bounce, way })
    {
    }
    ~Because() { s_now = m_before; }
    Because(const Because&) = delete;
    Because& operator=(const Because&) = delete;

    [[nodiscard]] static const Cause& now() { return s_now; }

private:
    explicit Because(const Cause& cause)
        : m_before(s_now)
    {
        s_now = cause;
    }

    static inline constinit thread_local Cause s_now;
    Cause m_before;
};

}
