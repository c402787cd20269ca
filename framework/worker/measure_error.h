#pragma once
#include "worker/sampling_error.h"

namespace worker {

// What the submission's sampling errs, against truth::areaOf and truth::contribution. Estimates go over the places of
// the integrand in turn: pixels along the edge, points in the light.
[[nodiscard]] ErrorAnswer measureError(const ErrorRequest& request);

}
