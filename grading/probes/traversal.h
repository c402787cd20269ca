#pragma once
#include "common.h"

// What the probe of the tree's traversal answers.
namespace grading {

struct Traversal {
    uint8_t isHit; // 0 or 1; in a bool any other byte from another process would be undefined
    float t; // the ray's, afterwards
    HitInfo hitInfo;
};

}
