#include "debug/recording.h"
#include "debug/tally.h"
#include "draw.h"

void drawAABB(const AxisAlignedBox& box, DrawMode drawMode, const glm::vec3& color, float transparency)
{
    debug::Tally::addNode();
    if (debug::Recording::isOpen())
        debug::Recording::add(debug::DrawnBox { box, drawMode, color, transparency });
}
