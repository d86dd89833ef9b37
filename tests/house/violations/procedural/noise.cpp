// Line 3 is wrong.
#include "atlas/vec.h"
#include "atlas/mesh.h"
#include <vector>
