#pragma once
#include "grading/stress/probes/rays.h"

namespace stress {

// What follows from a hit of one triangle.
struct Spawned {
    uint8_t isHit; // otherwise nothing follows
    Ray ray; // up to the hit
    Ray reflected, passedThrough;
    uint8_t reflectedMeets, passedThroughMeets; // the same triangle again
};

}
