#pragma once
#include "common.h"
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace files {

// The settings of Features by the names that scene files and `render --set` use, such as "normal_interp".
[[nodiscard]] std::vector<std::string> featureNames();

// In the order of ShadingModel.
[[nodiscard]] std::vector<std::string> shadingModelNames();

// Of a switch a bool, of a count an integer, of the shading model a name.
using FeatureValue = std::variant<bool, int64_t, std::string>;

struct CountRange {
    int64_t least, most;
};

// Of a count that featureNames() has.
[[nodiscard]] CountRange countRange(std::string_view name);

// The value of one that featureNames() has.
[[nodiscard]] FeatureValue featureValue(const Features& features, std::string_view name);

// Sets one. Throws std::invalid_argument, whose text says what was found and what was expected.
void setFeatureValue(Features& features, std::string_view name, const FeatureValue& value);

// Sets one from text: true or false, a count, or the name of a shading model.
void setFeature(Features& features, std::string_view name, std::string_view value);

}
