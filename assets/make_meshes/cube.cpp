// The cube of the papers' marble and wood blocks: side 2 about the origin, two triangles a face.
#include "assets/make_meshes/model.h"

namespace burl {

Model make_cube() {
    Model model;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3d out(0.0), u(0.0), v(0.0);
        out[axis] = u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1.0;
        model.quad(out - u - v, out + u - v, out + u + v, out - u + v);
        model.quad(-out - u - v, -out - u + v, -out + u + v, -out + u - v);
    }
    return model;
}

}  // namespace burl
