#pragma once

namespace accel::wide {

// All that rounding may take away, in the tests of boxes and of triangles, is given to the boxes beforehand: they count
// as larger by a margin. With u the largest relative error of one rounding, 2^-24: the triangle test moves corners by
// up to 5 u of what they are away along each of two axes (Woop, Benthin, Wald 2013, section 4), and a ray that it finds
// on a triangle must pass through its box; a distance to a plane has 3 u of the way, and 4 u of the coordinates.
inline constexpr float marginOfReach = 16 * 0x1p-24f; // from origin to farthest corner: 10 + 3, and the second order
inline constexpr float marginOfOrigin = 5 * 0x1p-24f;

}
