#pragma once
#include "grading/probes/incidence.h"
#include "worker/message.h"

// What the probes of the recursive functions are asked, and answer.
namespace grading {

// A surface in the way of a ray, wherever that goes.
struct ScriptedHit {
    glm::vec3 normal; // unit; turned to face the ray
    float t;
    Material material;
};

// A call of one of the two components, in a world that is made up as rays are sent. Shading and shadows are off: a hit
// has the colour light * kd, and what the component adds.
struct Recursion {
    Incidence incidence;
    glm::vec3 hitColor;
    int rayDepth;
    glm::vec3 light; // of the only light
    std::vector<ScriptedHit> hits; // what further rays meet, one after another; after the last they miss
};

struct RecursionAnswer {
    glm::vec3 hitColor;
    std::vector<Ray> rays; // that were sent, as they were sent
};

inline worker::Message& operator<<(worker::Message& message, const Recursion& r)
{
    return message << r.incidence << r.hitColor << r.rayDepth << r.light << r.hits;
}

inline worker::Reader& operator>>(worker::Reader& reader, Recursion& r)
{
    return reader >> r.incidence >> r.hitColor >> r.rayDepth >> r.light >> r.hits;
}

inline worker::Message& operator<<(worker::Message& message, const RecursionAnswer& answer)
{
    return message << answer.hitColor << answer.rays;
}

inline worker::Reader& operator>>(worker::Reader& reader, RecursionAnswer& answer)
{
    return reader >> answer.hitColor >> answer.rays;
}

}
