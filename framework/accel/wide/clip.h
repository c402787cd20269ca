#pragma once
#include "accel/wide/box.h"

namespace accel::wide {

// The part of a box's triangle on either side of a plane across an axis. Boxes are rounded outwards: together they
// hold all that the box held of the triangle.
struct Halves {
    Box lower, upper;
};

[[nodiscard]] Halves clip(const Box& box, const Triangle& triangle, int axis, float position);

}
