// Lines 3 to 5 are wrong.
#include "app/gl/context.h"
#include "procedural/noise/noise.h"
#include <glad/gl.h>
#  include <GL/osmesa.h>
