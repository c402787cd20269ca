#pragma once
#include <string_view>

namespace report {

// page.html with its style and its script; in it {{title}}, {{heading}}, {{summary}}, {{navigation}} and {{sections}},
// in this order, stand where these go.
extern const std::string_view pageFrame;

}
