#pragma once
// All of a Wavefront OBJ, for an OBJ written anew: what read_mesh() leaves out of a mesh (groups,
// materials, polygons, points and lines) and where each of its corners comes from.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/file/file_buffer.h"
#include "atlas/mesh/mesh.h"
#include "atlas/mesh/polygon_soup.h"

namespace burl {

/// A line of an OBJ that stays where it stands between others.
struct ObjStatement {
    enum class Kind { face, element, text } kind = Kind::text;
    std::uint32_t face = 0;  ///< the number of a face, from 0
    std::string text{};  ///< the line, as one where it is joined; of an element (p, l) its keyword
    /// The vertices of an element with their texture coordinates, from 0, the second no_index where
    /// there are none.
    std::vector<std::array<std::uint32_t, 2>> element{};
};

/// The content of an OBJ by its own numbers, from 0.
struct ObjSource {
    FileBuffer file;
    std::vector<std::string_view> points, uvs, normals;  ///< the lines v, vt and vn, as they are
    std::vector<std::string> libraries;                  ///< what follows mtllib
    std::vector<ObjStatement> statements;                ///< all others but comments and materials
    std::vector<std::string> materials;                  ///< names of usemtl, by first use
    std::vector<std::uint32_t> material_of_face;         ///< indices into materials, or no_index
    PolygonSoup faces;                                   ///< the faces' corners
    std::vector<std::size_t> first_corner;  ///< per face its first corner in `faces`, and the end
    std::uint64_t left_out = 0;             ///< lines of free-form surfaces, which are left out

    std::size_t face_size(std::uint32_t face) const {
        return first_corner[face + 1] - first_corner[face];
    }
};

/// Reads a whole OBJ. Throws Error(invalid_file) as read_mesh() does.
ObjSource read_obj_source(FileBuffer file);

/// Which faces have a material that one of the patterns (atlas/base/glob.h) fits; a face before the
/// first usemtl is of "no material". Throws Error(usage), with the file's materials, for a pattern
/// that fits none.
std::vector<char> faces_of_materials(const ObjSource& source,
                                     const std::vector<std::string>& patterns);

/// The point of the mesh at each corner of `source.faces`; no_index for faces that the mesh lacks.
/// The mesh is the one read from this file, or faces of it. Throws Error(runtime) where it has
/// other faces, as after a file has changed.
std::vector<std::uint32_t> points_of_corners(const ObjSource& source, const Mesh& mesh);

}  // namespace burl
