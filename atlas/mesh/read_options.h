#pragma once
// How a file becomes a mesh, where that is a user's choice.

namespace burl {

struct ReadOptions {
    /// Points closer than this times the box's longest side are welded; 0 welds bitwise-equal
    /// points (after -0 -> 0).
    double weld = 0.0;
    /// Give each glTF instance triangles of its own, in scene space, instead of baking the first
    /// one for all.
    bool unshare_instances = false;
};

}  // namespace burl
