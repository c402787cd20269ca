#pragma once
#include "files/obj_data.h"

namespace files {

// Cuts the faces of four corners or more anew: those of four along the shorter diagonal, others as tinyobj cuts off
// ears, if it finds all of them. Positions of all corners must be there.
void cutFans(ObjData& data);

}
