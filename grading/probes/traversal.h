#pragma once
#include "common.h"

// What the probe of the tree's traversal answers.
namespace grading {

struct Traversal {
    bool isHit;
    float t; // the ray's, afterwards
    HitInfo hitInfo;
};

}
