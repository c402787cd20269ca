#include "accel/counting_bvh.h"
#include "light.h"

void lighting::countUnlit()
{
    accel::CountingBVH::addUnlit();
}
