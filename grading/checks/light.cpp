#include "grading/check.h"
