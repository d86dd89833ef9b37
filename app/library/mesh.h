#pragma once
// Triangle meshes from files and from arrays.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/library/error.h"
#include "app/library/progress.h"

namespace burl::library {

/// How a file becomes a mesh.
struct MeshReading {
    /// Welding distance as a share of the box's longest side, 0 to 0.1; 0 welds equal points alone.
    double weld = 0.0;
    /// Axis of the file that points up: "x", "-x", "y", "-y", "z" or "-z". The mesh is turned so
    /// that it is +y.
    std::string up = "y";
    /// Factor of the file's coordinates, 1e-9 to 1e9.
    double scale = 1.0;
    /// The N of a glTF's TEXCOORD_N that texture coordinates are read from, 0 to 15.
    std::uint32_t uv_set = 0;
    /// Is told that the file is being read, and may stop that; empty: nobody is.
    Progress progress{};
};

/// A triangle mesh, which does not change once it is made. Copies share the arrays. Any number of
/// threads may use a mesh at once.
class BURL_API Mesh {
  public:
    /// Reads an .obj, .ply, .stl, .off, .gltf or .glb file, or a sample that the library brings
    /// along, such as "sample:teapot". Throws Error: io when the file cannot be read, invalid_file
    /// when its content is wrong, unsupported for another format, usage for an unknown sample and
    /// for values of `reading` out of range, stopped where the callback says so.
    static Mesh read(const std::string& path, const MeshReading& reading = {});

    /// Makes a mesh of arrays, which are copied. `positions` has shape (points, 3), in mesh units;
    /// `triangles` has shape (triangles, 3), numbers of points from 0; `uvs` is empty or has shape
    /// (triangles, 3, 2), a texture coordinate per corner, v = 0 at an image's row 0. Points with
    /// the same bits become one, and points are numbered by first use; triangles keep their order.
    /// `name` goes into files that are written. Throws Error(usage) for sizes that do not fit these
    /// shapes, for numbers that are not finite, for triangles that refer to no point and where
    /// there is no triangle.
    Mesh(std::span<const double> positions, std::span<const std::uint32_t> triangles,
         std::span<const double> uvs = {}, const std::string& name = "mesh");

    /// The name: that of the file without folder and extension, or as it was given.
    const std::string& name() const;
    /// The points, shape (points, 3), in mesh units; valid as long as a copy of the mesh is.
    std::span<const double> positions() const;
    /// The points of each triangle's corners, shape (triangles, 3); valid as positions() is.
    std::span<const std::uint32_t> triangles() const;
    /// The mesh's own texture coordinates per corner, shape (triangles, 3, 2), v = 0 at an image's
    /// row 0; empty where it has none. Valid as positions() is.
    std::span<const double> uvs() const;
    /// Sentences on what reading repaired or left out; empty where there is nothing to tell.
    std::vector<std::string> notes() const;

    /// The library's own representation.
    struct State;
    /// The library's own representation.
    const State& state() const { return *state_; }

  private:
    explicit Mesh(std::shared_ptr<const State> state);
    std::shared_ptr<const State> state_;
};

}  // namespace burl::library
