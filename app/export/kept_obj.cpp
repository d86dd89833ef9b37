// Wavefront OBJ written anew: the source's lines in their order, with its points first, so that
// they keep their numbers, then the texture coordinates and normals, then all the rest.
#include <algorithm>
#include <filesystem>
#include <unordered_map>

#include <fmt/compile.h>

#include "app/export/obj_text.h"
#include "app/surface/node_transform.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"
#include "atlas/file/text_scanner.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/obj_libraries.h"

namespace burl {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t corners_searched = 16;  ///< of a face, which are searched one by one

/// Prints a line of the file as one line. A blank keeps a `\` at its end from joining the next one.
void put_line(ObjText& text, std::string_view keyword, std::string_view line) {
    std::string joined;
    if (line.find('\\') != std::string_view::npos) line = joined = as_one_line(line);
    put(text, FMT_COMPILE("{}{}{}\n"), keyword, line, line.ends_with('\\') ? " " : "");
}

/// A new text for an OBJ whose faces have been given other texture coordinates.
class ObjRewriter {
  public:
    ObjRewriter(const SceneContent& content, const Mesh& shown, std::span<const Vec3f> normals)
        : content_(content),
          kept_(*content.options.obj),
          source_(kept_.source),
          mesh_(content.mesh),
          shown_(shown),
          lines_(corner_lines(content.atlas, normals)),
          colors_(shown_colors(content, shown)) {
        find_triangles();
        place_points();
        const bool posed = content.options.pose.has_value();
        keeps_normals_ = !posed && !source_.faces.normals.values.empty();
        own_normal_.assign(lines_.normals.size(), 0);
    }

    ObjText text(const std::string& mtl_name, const std::string& material);

  private:
    void find_triangles();
    void place_points();
    void place_point(std::uint32_t point, std::uint32_t shown);
    void tell_cut() const;
    void print_statements(const std::string& material);
    void print_element(const ObjStatement& element);
    void print_kept_face(std::uint32_t face);
    void print_carved_face(std::uint32_t face);
    bool print_polygon(std::uint32_t face);
    void print_triangle(std::uint32_t face, std::uint32_t t);
    void print_libraries(ObjText& text) const;
    void print_points(ObjText& text) const;
    void print_normals(ObjText& text) const;
    void use(std::uint32_t material, const std::string& name);

    bool is_carved(std::uint32_t face) const { return first_[face + 1] > first_[face]; }
    bool keeps_faces() const { return carved_ < source_.material_of_face.size(); }
    std::uint32_t corner_of(std::uint32_t face, std::uint32_t point);
    std::uint32_t corner_of_large(std::uint32_t face, std::uint32_t point);
    std::size_t point_number(std::uint32_t face, std::uint32_t t, std::size_t k);
    std::size_t normal_number(std::uint32_t source_corner, std::size_t corner);

    const SceneContent& content_;
    const KeptObj& kept_;
    const ObjSource& source_;
    const Mesh &mesh_, &shown_;
    CornerLines lines_;
    std::vector<std::uint32_t> first_;  ///< per face of the file its first triangle, and the end
    std::vector<std::uint32_t> cut_;    ///< corners_of_triangles() of the file
    std::size_t carved_ = 0;            ///< faces that the mesh has
    std::vector<Vec4f> colors_;         ///< shown_colors()
    std::vector<Vec4f> place_colors_;   ///< of places_; empty without vertex colours
    std::vector<char> is_colored_;      ///< whether the file's point is of a textured face
    std::vector<Vec3d> places_;         ///< the file's points as they are written
    bool keeps_normals_ = false;        ///< whether the file's normals are written
    std::unordered_map<std::uint32_t, std::size_t> extra_;  ///< numbers of points beyond the file's
    std::vector<Vec3d> extra_places_;
    std::vector<std::size_t> own_normal_;  ///< numbers of lines_.normals; 0: not written
    std::vector<Vec3f> own_normals_;
    ObjText statements_;
    std::unordered_map<std::uint32_t, std::uint32_t> table_;  ///< of corner_of_large()
    std::uint32_t table_of_ = no_index;
    std::size_t polygons_ = 0, cut_polygons_ = 0;
    std::size_t used_ = no_material;  ///< the material in use, an index, or one of the two below
    static constexpr std::size_t no_material = std::size_t(-1), own_material = std::size_t(-2);
};

void ObjRewriter::find_triangles() {
    const std::size_t faces = source_.material_of_face.size();
    first_.assign(faces + 1, 0);
    for (const std::uint32_t face : mesh_.source_faces) ++first_[face + 1];
    for (std::size_t face = 0; face < faces; ++face) {
        carved_ += first_[face + 1] > 0;
        first_[face + 1] += first_[face];
    }
    PolygonSoup soup = source_.faces;
    cut_ = corners_of_triangles(soup);
}

// A point of the file is one point of every pose, so any corner at it tells where it is.
void ObjRewriter::place_points() {
    const bool stays = frame_transform(kept_.frame) == Mat4d(1.0);
    const FramePoints framed_point(kept_.frame);
    for (const Vec3d& p : source_.faces.points) places_.push_back(stays ? p : framed_point(p));
    for (std::uint32_t face = 0; face + 1 < first_.size(); ++face)
        for (std::uint32_t t = first_[face]; t < first_[face + 1]; ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t corner = corner_of(face, mesh_.triangles[t][k]);
                if (corner != no_index)
                    place_point(source_.faces.corners[corner], shown_.triangles[t][k]);
            }
}

void ObjRewriter::place_point(std::uint32_t point, std::uint32_t shown) {
    places_[point] = shown_.positions[shown];
    if (colors_.empty()) return;
    place_colors_.resize(places_.size());
    is_colored_.resize(places_.size(), 0);
    place_colors_[point] = colors_[shown];
    is_colored_[point] = 1;
}

/// The file's corner of the face at a point of the mesh; no_index for a point that the atlas made.
std::uint32_t ObjRewriter::corner_of(std::uint32_t face, std::uint32_t point) {
    const std::size_t begin = source_.first_corner[face], end = source_.first_corner[face + 1];
    if (end - begin > corners_searched) return corner_of_large(face, point);
    for (std::size_t c = begin; c < end; ++c)
        if (kept_.points[c] == point) return std::uint32_t(c);
    return no_index;
}

/// corner_of() by a table of the face, which is kept until another face comes.
std::uint32_t ObjRewriter::corner_of_large(std::uint32_t face, std::uint32_t point) {
    if (table_of_ != face) {
        table_.clear();
        for (std::size_t c = source_.first_corner[face]; c < source_.first_corner[face + 1]; ++c)
            table_.try_emplace(kept_.points[c], std::uint32_t(c));
        table_of_ = face;
    }
    const auto known = table_.find(point);
    return known == table_.end() ? no_index : known->second;
}

/// The number, from 1, of the point of a triangle's corner, which may be a new one.
std::size_t ObjRewriter::point_number(std::uint32_t face, std::uint32_t t, std::size_t k) {
    const std::uint32_t point = mesh_.triangles[t][k], corner = corner_of(face, point);
    if (corner != no_index) return 1 + std::size_t(source_.faces.corners[corner]);
    const auto [known, fresh] =
        extra_.try_emplace(point, source_.points.size() + extra_places_.size() + 1);
    if (fresh) extra_places_.push_back(shown_.positions[shown_.triangles[t][k]]);
    return known->second;
}

/// The number, from 1, of the normal of a triangle's corner, which is the file's where it has one.
std::size_t ObjRewriter::normal_number(std::uint32_t source_corner, std::size_t corner) {
    const auto& normals = source_.faces.normals;
    if (keeps_normals_ && source_corner != no_index) {
        const std::uint32_t normal = normals.of_corner[source_corner];
        if (normal != no_index && normals.values[normal] != Vec3f(0.0f)) return 1 + normal;
    }
    std::size_t& own = own_normal_[lines_.normal[corner] - 1];
    if (own == 0) {
        own_normals_.push_back(lines_.normals[lines_.normal[corner] - 1]);
        own = (keeps_normals_ ? source_.normals.size() : 0) + own_normals_.size();
    }
    return own;
}

/// Prints a face as the file has it, unless the atlas cuts it or its corners have several normals;
/// returns whether it did. Its first corner stays the first, since programs that cut polygons as
/// fans, as most do, then show the triangles that the texture was made for.
bool ObjRewriter::print_polygon(std::uint32_t face) {
    const std::size_t size = source_.face_size(face), begin = source_.first_corner[face];
    if (first_[face + 1] - first_[face] != size - 2) return false;
    std::vector<std::size_t> uv(size, 0), normal(size, 0);
    const std::size_t first_cut = 3 * (begin - 2 * std::size_t(face));
    for (std::size_t i = 0; i < 3 * (size - 2); ++i) {
        const std::size_t corner = 3 * std::size_t(first_[face]) + i;
        const std::size_t at = (cut_.empty() ? first_cut + i : cut_[first_cut + i]);
        const std::size_t n = normal_number(std::uint32_t(at), corner);
        const std::size_t k = at - begin, vt = lines_.uv[corner];
        if ((uv[k] != 0 && uv[k] != vt) || (normal[k] != 0 && normal[k] != n)) return false;
        uv[k] = vt, normal[k] = n;
    }
    statements_.push_back('f');
    const std::size_t offset = keeps_faces() ? source_.uvs.size() : 0;
    for (std::size_t k = 0; k < size; ++k)
        print_corner(statements_, 1 + std::size_t(source_.faces.corners[begin + k]),
                     uv[k] == 0 ? 0 : uv[k] + offset, normal[k]);
    statements_.push_back('\n');
    return true;
}

void ObjRewriter::print_triangle(std::uint32_t face, std::uint32_t t) {
    const std::size_t offset = keeps_faces() ? source_.uvs.size() : 0;
    statements_.push_back('f');
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t corner = 3 * std::size_t(t) + k, uv = lines_.uv[corner];
        print_corner(statements_, point_number(face, t, k), uv == 0 ? 0 : uv + offset,
                     normal_number(corner_of(face, mesh_.triangles[t][k]), corner));
    }
    statements_.push_back('\n');
}

void ObjRewriter::print_carved_face(std::uint32_t face) {
    const bool polygon = source_.face_size(face) > 3;
    polygons_ += polygon;
    if (print_polygon(face)) return;
    cut_polygons_ += polygon;
    for (std::uint32_t t = first_[face]; t < first_[face + 1]; ++t) print_triangle(face, t);
}

void ObjRewriter::print_kept_face(std::uint32_t face) {
    const PolygonSoup& faces = source_.faces;
    statements_.push_back('f');
    for (std::size_t c = source_.first_corner[face]; c < source_.first_corner[face + 1]; ++c) {
        put(statements_, FMT_COMPILE(" {}"), 1 + std::size_t(faces.corners[c]));
        const auto number = [&](const auto& attribute) {
            return attribute.of_corner.empty() ? no_index : attribute.of_corner[c];
        };
        const std::uint32_t uv = number(faces.uvs), normal = number(faces.normals);
        if (uv != no_index) put(statements_, FMT_COMPILE("/{}"), 1 + std::size_t(uv));
        if (normal != no_index && keeps_normals_)
            put(statements_, FMT_COMPILE("{}{}"), uv == no_index ? "//" : "/",
                1 + std::size_t(normal));
    }
    statements_.push_back('\n');
}

void ObjRewriter::print_element(const ObjStatement& element) {
    put(statements_, FMT_COMPILE("{}"), element.text);
    for (const auto& [point, uv] : element.element) {
        put(statements_, FMT_COMPILE(" {}"), 1 + std::size_t(point));
        if (uv != no_index && keeps_faces())
            put(statements_, FMT_COMPILE("/{}"), 1 + std::size_t(uv));
    }
    statements_.push_back('\n');
}

/// Prints usemtl where another material is in use. Faces before the file's first one get a name
/// that no library has, if another came before them here.
void ObjRewriter::use(std::uint32_t material, const std::string& name) {
    const std::size_t wanted = material == no_index ? no_material : material;
    if (used_ == wanted) return;
    used_ = wanted;
    put_line(statements_, "usemtl ", material == no_index ? name + "_none" : name);
}

void ObjRewriter::print_statements(const std::string& material) {
    for (const ObjStatement& statement : source_.statements) {
        if (statement.kind == ObjStatement::Kind::text) {
            put_line(statements_, "", statement.text);
        } else if (statement.kind == ObjStatement::Kind::element) {
            print_element(statement);
        } else if (is_carved(statement.face)) {
            if (used_ != own_material) put(statements_, FMT_COMPILE("usemtl {}\n"), material);
            used_ = own_material;
            print_carved_face(statement.face);
        } else {
            const std::uint32_t own = source_.material_of_face[statement.face];
            use(own, own == no_index ? material : source_.materials[own]);
            print_kept_face(statement.face);
        }
    }
}

/// Prints the file's libraries, as seen from the new file's folder.
void ObjRewriter::print_libraries(ObjText& text) const {
    if (!keeps_faces()) return;
    const fs::path from = fs::absolute(source_.file.path).parent_path().lexically_normal(),
                   to = fs::absolute(content_.path).parent_path().lexically_normal();
    for (const std::string& line : source_.libraries) {
        if (from == to) put_line(text, "mtllib ", line);
        for (const std::string& library :
             from == to ? std::vector<std::string>() : libraries_of(line, from)) {
            const fs::path path(library);
            put_line(text, "mtllib ",
                     (path.is_absolute() ? path : (from / path).lexically_relative(to))
                         .generic_string());
        }
    }
}

/// Prints all points, those of the file as it has them where they have not moved, with the file's
/// colours. Those of a file that is carved as a whole would tint the texture.
void ObjRewriter::print_points(ObjText& text) const {
    const std::vector<Vec4f>& colors = source_.faces.colors.values;
    const bool drops_colors = !colors.empty() && !keeps_faces();
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const bool has_color = !is_colored_.empty() && is_colored_[i];
        if (has_color)
            print_point(text, places_[i], &place_colors_[i]);
        else if (places_[i] == source_.faces.points[i] && !drops_colors)
            put_line(text, "", source_.points[i]);
        else
            print_point(text, places_[i], colors.empty() || drops_colors ? nullptr : &colors[i]);
    }
    for (const Vec3d& place : extra_places_) print_point(text, place);
}

void ObjRewriter::print_normals(ObjText& text) const {
    const Mat4d frame = frame_transform(kept_.frame);
    const bool turned = frame != Mat4d(1.0);
    const NormalTransform turn(frame);
    for (std::size_t i = 0; keeps_normals_ && i < source_.normals.size(); ++i) {
        if (turned)
            print_normal(text, turn(source_.faces.normals.values[i]));
        else
            put_line(text, "", source_.normals[i]);
    }
    for (const Vec3f& normal : own_normals_) print_normal(text, normal);
}

void ObjRewriter::tell_cut() const {
    if (cut_polygons_ == 0 || !content_.options.tell) return;
    content_.options.tell(
        fmt::format("the atlas cuts {} of {} polygons, which are written as triangles",
                    cut_polygons_, polygons_));
}

ObjText ObjRewriter::text(const std::string& mtl_name, const std::string& material) {
    print_statements(material);
    tell_cut();
    ObjText text;
    put(text, FMT_COMPILE("# Burl " BURL_VERSION "\nmtllib {}\n"), mtl_name);
    print_libraries(text);
    print_points(text);
    for (std::size_t i = 0; keeps_faces() && i < source_.uvs.size(); ++i)
        put_line(text, "", source_.uvs[i]);
    text.append(lines_.text);
    print_normals(text);
    text.append(statements_);
    return text;
}

}  // namespace

ObjText kept_obj_text(const SceneContent& content, const Mesh& shown,
                      std::span<const Vec3f> normals, const std::string& mtl_name,
                      const std::string& material) {
    return ObjRewriter(content, shown, normals).text(mtl_name, material);
}

std::shared_ptr<const KeptObj> kept_obj(const std::string& path, const Mesh& mesh,
                                        const MeshFrame& frame) {
    if (!is_sample_mesh(path) && lower_extension(path) != ".obj") return nullptr;
    auto kept = std::make_shared<KeptObj>();
    kept->source = read_obj_source(mesh_bytes(path));
    kept->frame = frame;
    kept->points = points_of_corners(kept->source, mesh);
    return kept;
}

}  // namespace burl
