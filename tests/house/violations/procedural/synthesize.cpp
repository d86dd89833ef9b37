// A synthesiser may include atlas, but not app: line 3 is wrong.
#include "atlas/mesh.h"
#include "app/recipe.h"
