// Lines 2 to 4 are wrong, line 5 is a comment, line 6 is right.
#include "app/recipe.h"
#include "../procedural/texture.h"
	#include "procedural/texture.h"
// #include "app/recipe.h"
#include "atlas/mesh.h"
