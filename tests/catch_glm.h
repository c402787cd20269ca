#pragma once
#include <catch2/catch.hpp>
#include <glm/glm.hpp>
#include <glm/gtx/string_cast.hpp>

// A failed check shows vectors. Part of the precompiled header: every test is to see the same printer.
template <int L, typename T, glm::qualifier Q> struct Catch::StringMaker<glm::vec<L, T, Q>> {
    static std::string convert(const glm::vec<L, T, Q>& v) { return glm::to_string(v); }
};
