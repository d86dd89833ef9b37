// Right.
#include <vector>

#include "atlas/base/vec.h"
