#pragma once
// Lines of Wavefront OBJ, which both ways of writing one share. Text holds every digit.
#include <array>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/export/formats.h"

namespace burl {

using ObjText = fmt::memory_buffer;

template <class... Values>
void put(ObjText& text, Values&&... values) {
    fmt::format_to(std::back_inserter(text), std::forward<Values>(values)...);
}

/// The name with control characters replaced, and a `\` at its end, since it ends at the line's end
/// and must not start another line, nor join it; "mesh" for an empty name.
std::string one_line(std::string name);

/// The name with spaces and "#" replaced, which end names or lines for readers, and a `\` at its
/// end, which joins lines.
std::string without_spaces(std::string name);

/// For each corner the numbers, from 1, of its vt and vn lines; the normals of the vn lines; and
/// the text of the vt lines.
struct CornerLines {
    std::vector<std::uint32_t> uv, normal;
    std::vector<Vec3f> normals;
    ObjText text;
};

/// The lines of these normals, one per triangle corner, and of the atlas's places, if there is one:
/// without, all numbers of vt are 0.
CornerLines corner_lines(const Atlas& atlas, std::span<const Vec3f> normals);

/// Prints a corner of a face by its numbers; `uv` 0 means that it has no texture coordinate.
void print_corner(ObjText& text, std::size_t point, std::size_t uv, std::size_t normal);

/// Per point of the shown mesh its colour, from those of the content's mesh; empty where the scene
/// has no vertex colours.
std::vector<Vec4f> shown_colors(const SceneContent& content, const Mesh& shown);

/// Prints a point; with a colour in linear light, as codes of sRGB from 0 to 1, as Blender and
/// MeshLab read them.
void print_point(ObjText& text, const Vec3d& p, const Vec4f* color = nullptr);
void print_normal(ObjText& text, const Vec3f& n);

/// The text of an OBJ that keeps of `content.options.obj` all that is not changed: groups,
/// polygons, normals, and the faces that the mesh lacks, with their materials and texture
/// coordinates. Faces of the mesh have `material` of the library `mtl_name`; polygons that the
/// atlas cuts become triangles, which is told. `shown` is the mesh with its points as they are
/// written, and `normals` its own, one per triangle corner.
ObjText kept_obj_text(const SceneContent& content, const Mesh& shown,
                      std::span<const Vec3f> normals, const std::string& mtl_name,
                      const std::string& material);

}  // namespace burl
