#include "extra.h"

void postprocessImageWithBloom(const Scene&, const Features&, const Trackball&, Screen&) { }
