#pragma once
#include <string_view>

namespace grading::html {

// page.html with its style and script in it; {{data}} stands where the page expects the grade as JSON.
extern const std::string_view page;

}
