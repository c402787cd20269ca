#pragma once
#include "common.h"
#include "grading/probes/interpolation.h"
#include "worker/message.h"

// What the probes of intersections are asked, and what they answer.
namespace stress {

struct TriangleRay {
    grading::Triangle triangle;
    Ray ray;
};

struct BoxRay {
    AxisAlignedBox box;
    Ray ray;
};

struct Met {
    uint8_t isHit; // 0 or 1
    float t; // the ray's, afterwards
    glm::vec3 normal; // of a triangle that was hit
};

// Triangles, each with a material of its own, and rays through them.
struct Soup {
    std::vector<grading::Triangle> triangles;
    std::vector<Ray> rays;
};

struct MetInSoup {
    Met met;
    float triangle; // its number, by the material
    glm::vec3 barycentric;
};

inline worker::Message& operator<<(worker::Message& message, const Soup& soup)
{
    return message << soup.triangles << soup.rays;
}

inline worker::Reader& operator>>(worker::Reader& reader, Soup& soup)
{
    return reader >> soup.triangles >> soup.rays;
}

}
