#include "app/surface/normal_frames.h"

#include "app/surface/normals.h"
#include "app/surface/tangents.h"

namespace burl {

NormalFrames make_normal_frames(const Mesh& mesh, const MeshAtlas& atlas,
                                const NormalFramesKey& key) {
    const Mesh& placed = atlas.mesh(mesh);
    NormalFrames frames{key};
    frames.positions = map_positions(placed, solid_from_mesh(mesh, key.space));
    frames.normals = corner_normals(placed, key.crease_degrees);
    if (key.tangents)
        frames.tangents = corner_tangents(placed.positions, placed.triangles,
                                          corner_uvs(atlas.atlas()), frames.normals);
    return frames;
}

}  // namespace burl
