#pragma once
// A user's choices of how a file becomes a mesh.

namespace burl {

struct ReadOptions {
    /// Welding distance as a share of the box's longest side: closer points are welded; 0 welds
    /// points with the same bits (-0 counts as 0).
    double weld = 0.0;
    /// Whether each glTF instance gets triangles of its own, in scene space, instead of sharing
    /// those of the first instance.
    bool unshare_instances = false;
};

}  // namespace burl
