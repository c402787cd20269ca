#pragma once
#include "worker/explanation.h"

namespace app {

// Prints what a picture needs, what is left out and why, and what was counted.
void explain(const worker::Explanation& explanation);

}
