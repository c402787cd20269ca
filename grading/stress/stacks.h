#pragma once
#include "grading/stress/probes/stack.h"
#include "grading/stress/random.h"
#include <string>

// Panes above each other, for lights and rays to go through.
namespace stress {

[[nodiscard]] std::string describeStack(const Stack& stack);

// Without panes, in any position; of any size from 1e-3 to 1e3, and beside the origin: twice to three times that from
// its axis. A hit near the origin would lie beside a large pane by more than any number that its ray is made of tells.
[[nodiscard]] Stack anyStack(Random& random);

// So many panes of glass above the highest, a hundredth of the stack's size apart or more: rays may start a thousandth
// beside a surface.
void addGlass(Random& random, Stack& stack, int count);

}
