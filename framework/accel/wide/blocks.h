#pragma once
#include "accel/wide/large_pages.h"
#include "accel/wide/node.h"
#include "accel/wide/triangles.h"
#include <vector>

namespace accel::wide {

using Blocks = std::vector<Block, LargePages<Block>>;

// Adds as many blocks as these take, each once; sorts them.
void addBlocks(std::vector<uint32_t>& primitives, const Triangles& triangles, Blocks& blocks);

}
