// Values between the corners of a triangle.
//
// To read: Ericson 2005, "Real-Time Collision Detection", 3.4 "Barycentric Coordinates" and 5.1.5 "Closest Point on
// Triangle to Point"; Marschner and Shirley, "Fundamentals of Computer Graphics", chapter "Miscellaneous Math",
// section "Triangles". Debug drawing: nothing here knows where the hit is, so the normals at the corners and the one
// in between (yellow) are drawn by who calls these functions, your BVH::intersect.
#include "interpolate.h"
#include "not_written_yet.h"

#pragma GCC diagnostic ignored "-Wunused-parameter" // delete this line when the whole file is written

// (alpha, beta, gamma) for (v0, v1, v2): alpha * v0 + beta * v1 + gamma * v2 is the point of the triangle closest to
// p; each is in [0, 1], their sum is 1. Inside, alpha is the area of the triangle (p, v1, v2) over that of
// (v0, v1, v2), and so on around.
//
// - Begin with points inside. Areas need a sign, or points outside get coordinates that sum to more than 1.
// - p may lie off the plane: only its projection counts.
// - Outside, the closest point is on an edge or a corner. Cutting negative coordinates off and scaling the rest to
//   sum 1 gives a point of the edge, but not the closest one.
// - A triangle can be as thin as a line or as small as a point: an area of 0 must not become a NaN.
// - In C++ 1 / 2 is 0.
glm::vec3 computeBarycentricCoord(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2, const glm::vec3& p)
{
    notWrittenYet("computeBarycentricCoord"); // delete this line when the function is written
    return glm::vec3(1.0f / 3.0f);
}

// The direction of alpha * n0 + beta * n1 + gamma * n2, as a unit vector; bc holds (alpha, beta, gamma).
//
// - The mean of unit vectors is shorter than they are.
// - glm::normalize returns its result, it changes nothing in place.
glm::vec3 interpolateNormal(const glm::vec3& n0, const glm::vec3& n1, const glm::vec3& n2, const glm::vec3 bc)
{
    notWrittenYet("interpolateNormal"); // delete this line when the function is written
    return n0;
}

// alpha * t0 + beta * t1 + gamma * t2. Coordinates beyond [0, 1] are the texture's business, not this function's.
glm::vec2 interpolateTexCoord(const glm::vec2& t0, const glm::vec2& t1, const glm::vec2& t2, const glm::vec3 bc)
{
    notWrittenYet("interpolateTexCoord"); // delete this line when the function is written
    return t0;
}
