#pragma once
#include <string>

namespace submission {

// Whether this is the text of student/<name>.cpp as students get it: nothing in it is to be graded. Of a text that was
// changed at all, if only in a comment, nobody can say that.
[[nodiscard]] bool isAsHandedOut(const std::string& name, const std::string& text);

}
