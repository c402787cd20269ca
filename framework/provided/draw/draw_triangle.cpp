#include "debug/recording.h"
#include "draw.h"

void drawTriangle(const Vertex& v0, const Vertex& v1, const Vertex& v2)
{
    if (debug::Recording::isOpen())
        debug::Recording::add(debug::DrawnTriangle { v0, v1, v2 });
}
