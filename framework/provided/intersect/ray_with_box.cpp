#include "accel/box_test.h"
#include "intersect.h"

bool intersectRayWithShape(const AxisAlignedBox& box, Ray& ray)
{
    float entry;
    if (!accel::testBox(box, accel::RayForBoxes(ray), ray.t, entry))
        return false;
    ray.t = entry;
    return true;
}
