// Lines 2 to 4 and 7 are wrong, line 5 is a comment, line 6 is right.
#include "app/draw/render.h"
#include "../procedural/noise/noise.h"
	#include "procedural/noise/noise.h"
// #include "app/draw/render.h"
#include "atlas/base/vec.h"
#include "tests/paths.h"
