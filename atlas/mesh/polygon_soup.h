#pragma once
// The result of every mesh reader and the input of build_mesh(): the file's own vertices and
// polygons, nothing welded, triangulated or left out yet. Splitting the two lets each be measured
// alone.
#include <cstdint>
#include <string>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// Index that says "this corner has no such attribute".
inline constexpr std::uint32_t no_index = 0xffffffffu;

/// Values of one kind of attribute. With `of_corner` empty there is one value per point, otherwise
/// `of_corner` has one entry per corner: an index into `values`, or no_index.
template <typename Value>
struct SoupAttribute {
    std::vector<Value> values;
    std::vector<std::uint32_t> of_corner;
};

/// A run of consecutive faces that is drawn as one object, with its instances (see Part).
struct SoupPart {
    std::string name;
    std::size_t first_face = 0;
    std::size_t face_count = 0;
    std::vector<Mat4d> instances{Mat4d(1.0)};
};

/// Points, faces and attributes as a file has them.
struct PolygonSoup {
    std::vector<Vec3d> points;              ///< the file's vertices, finite
    std::vector<std::uint32_t> corners;     ///< indices into points, face after face, all in range
    std::vector<std::uint32_t> face_sizes;  ///< corners per face, >= 3; empty: all are triangles
    std::vector<std::uint32_t> source_faces;  ///< faces' numbers in the file; empty: 0, 1, 2 ...
    SoupAttribute<Vec3f> normals;             ///< normals of any length; zero means none
    SoupAttribute<Vec4f> colors;              ///< linear RGBA, 1 is full scale
    SoupAttribute<Vec2d> uvs;                 ///< texture coordinates, v = 0 at image row 0
    SoupAttribute<std::array<std::uint16_t, 4>> joints;
    SoupAttribute<Vec4f> weights;
    std::vector<SoupPart> parts;  ///< parts that cover all faces in order; empty: one part
    MeshNotes notes;              ///< ignored_elements and sentences of the reader

    std::size_t face_count() const {
        return face_sizes.empty() ? corners.size() / 3 : face_sizes.size();
    }

    /// Ends a face whose `size` corners have been pushed.
    void end_face(std::size_t size) {
        if (face_sizes.empty()) {
            if (size == 3) return;
            face_sizes.assign((corners.size() - size) / 3, 3);
        }
        face_sizes.push_back(static_cast<std::uint32_t>(size));
    }
};

/// Largest number of triangles of a mesh: corner numbers 3t+k stay within 31 bits.
inline constexpr std::size_t largest_triangle_count = 0x7fffffffu / 3;

}  // namespace burl
