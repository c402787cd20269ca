#pragma once
#include "values/stopwatch.h"

namespace bench {

using values::secondsOf;

}
