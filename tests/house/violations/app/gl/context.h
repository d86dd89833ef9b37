// Right: the one place for OpenGL.
#include <glad/gl.h>
