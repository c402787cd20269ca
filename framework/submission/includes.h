#pragma once
#include <string>

namespace submission {

// The first file of ours in a list of what was included that a submission has no business with: anything in our source
// tree but the headers of the interface. Empty if there is none. dependencies: as a compiler writes them for make.
[[nodiscard]] std::string firstForeignInclude(const std::string& dependencies);

}
