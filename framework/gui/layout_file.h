#pragma once
#include <string>

namespace gui {

// Where the places and sizes of panels are remembered: in the user's folder of settings, which is made if need be.
// Empty when there is no such folder.
[[nodiscard]] std::string layoutFile();

}
