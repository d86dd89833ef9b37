// Right: the one place for GL.
#include <glad/gl.h>
