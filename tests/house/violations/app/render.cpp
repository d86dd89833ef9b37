// GL outside gl_*: lines 3 and 4 are wrong.
#include "procedural/texture.h"
#include <glad/gl.h>
#  include <GL/osmesa.h>
