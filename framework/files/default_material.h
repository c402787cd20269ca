#pragma once
#include <framework/mesh.h>

namespace files {

// Of surfaces whose file names no material: light grey, since the kd = 0 of an empty Material is a black hole.
inline constexpr Material defaultMaterial { .kd = { 0.8f, 0.8f, 0.8f } };

}
