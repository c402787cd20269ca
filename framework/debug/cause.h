#pragma once
#include <cstdint>

namespace debug {

// On whose way something is traced or drawn.
enum class Way : uint16_t { Path, Shadow }; // from the camera on, or from a surface to a light
struct Cause { // small: it is set for every ray
    int16_t bounce = 0; // as deep as renderRay: 0 is the camera's ray
    Way way = Way::Path;

    [[nodiscard]] bool operator==(const Cause&) const = default;
};

// What this thread traces and draws while it lives is on the path, this deep. The innermost one counts.
class Because {
public:
    explicit Because(int bounce)
        : m_before(s_now)
    {
        s_now = { static_cast<int16_t>(bounce), Way::Path };
    }
    ~Because() { s_now = m_before; }
    Because(const Because&) = delete;
    Because& operator=(const Because&) = delete;

    [[nodiscard]] static const Cause& now() { return s_now; }

private:
    friend class TowardsLight;

    static inline constinit thread_local Cause s_now;
    Cause m_before;
};

// Somebody looks at what this thread traces or draws while one lives. Only then is a way to a light told from a path:
// for each of the many rays to a light even that would be too much.
class Watch {
public:
    Watch() { ++s_count; }
    ~Watch() { --s_count; }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    [[nodiscard]] static bool isOpen() { return s_count > 0; }

private:
    static inline constinit thread_local int s_count = 0;
};

// What this thread traces and draws while it lives is on the way to a light. Such ways lead nowhere else, so there is
// none before it to come back to.
class TowardsLight {
public:
    TowardsLight() { Because::s_now.way = Way::Shadow; }
    ~TowardsLight() { Because::s_now.way = Way::Path; }
    TowardsLight(const TowardsLight&) = delete;
    TowardsLight& operator=(const TowardsLight&) = delete;
};

}
