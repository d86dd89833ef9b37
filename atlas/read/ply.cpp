// Reads PLY (Turk 1994): vertices with their attributes, faces and triangle strips, from any layout
// the header declares. Vertex numbers are checked against the declared count, so faces may come
// first.
#include <algorithm>
#include <array>

#include "atlas/base/srgb.h"
#include "atlas/read/ply_file.h"
#include "atlas/read/readers.h"

namespace burl {
namespace {

/// Places of a vertex's scalar properties in the parser's row of values.
enum Slot : std::size_t { px, py, pz, nx, ny, nz, red, green, blue, alpha, tu, tv, slot_count };
constexpr std::size_t no_slot = slot_count;

const std::array<std::initializer_list<const char*>, slot_count> slot_names{{
    {"x"},
    {"y"},
    {"z"},
    {"nx"},
    {"ny"},
    {"nz"},
    {"red", "r", "diffuse_red"},
    {"green", "g", "diffuse_green"},
    {"blue", "b", "diffuse_blue"},
    {"alpha", "a", "diffuse_alpha"},
    {"s", "u", "texture_u", "texture_s"},
    {"t", "v", "texture_v", "texture_t"},
}};

/// Factor that takes a colour stored in `type` to a full scale of 1.
double color_scale(PlyType type) {
    constexpr std::array<double, 8> scales{127.0,        255.0,        32767.0, 65535.0,
                                           2147483647.0, 4294967295.0, 1.0,     1.0};
    return 1.0 / scales[static_cast<std::size_t>(type)];
}

template <typename Body>
class PlyParser {
  public:
    PlyParser(const FileBuffer& file, const PlyHeader& header)
        : path_(file.path), header_(header), body_(file, header) {
        for (const PlyElement& element : header.elements)
            if (element.name == "vertex") vertex_count_ = element.count;
        if (vertex_count_ >= no_index) throw invalid_file(path_, 0, "too many vertices");
    }

    PolygonSoup parse() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex") {
                parse_vertices(element);
                continue;
            }
            if (element.properties.empty()) continue;  // its rows take no bytes
            body_.begin_element(element);
            if (element.name == "face")
                parse_faces(element);
            else if (element.name == "tristrips")
                parse_strips(element);
            else
                skip(element);
        }
        finish();
        return std::move(soup_);
    }

  private:
    void parse_vertices(const PlyElement& element);
    void push_vertex(const std::array<double, slot_count>& values);
    void parse_faces(const PlyElement& element);
    void parse_corners(const PlyProperty& property);
    void parse_wedge_uvs(const PlyProperty& property);
    void end_face();
    void parse_strips(const PlyElement& element);
    void push_strip_corner(std::int64_t index);
    void skip(const PlyElement& element);
    void skip(const PlyProperty& property);
    void finish();
    std::uint32_t checked(std::int64_t index);
    int require_list(const PlyElement& element);

    const std::string& path_;
    const PlyHeader& header_;
    Body body_;
    PolygonSoup soup_;
    std::uint64_t vertex_count_ = 0;
    bool has_normals_ = false, has_colors_ = false, has_uvs_ = false;
    std::size_t face_begin_ = 0;        ///< first corner of the current face in soup_.corners
    std::vector<double> wedge_;         ///< texture coordinates s, t of the current face's corners
    SoupAttribute<Vec2d> wedge_uvs_;    ///< texture coordinates of corners, where faces carry them
    std::vector<std::uint32_t> strip_;  ///< strip's corners since the last restart
    std::uint64_t stitches_ = 0;
};

template <typename Body>
void PlyParser<Body>::parse_vertices(const PlyElement& element) {
    std::vector<std::size_t> slot_of(element.properties.size(), no_slot);
    std::array<double, slot_count> values{}, scales;
    scales.fill(1.0);
    std::array<bool, slot_count> present{};
    values[alpha] = 1.0;
    for (std::size_t slot = 0; slot < slot_count; ++slot) {
        const int found = element.find(slot_names[slot]);
        if (found < 0 || element.properties[static_cast<std::size_t>(found)].is_list) continue;
        present[slot] = true;
        slot_of[static_cast<std::size_t>(found)] = slot;
        if (slot >= red && slot <= alpha)
            scales[slot] = color_scale(element.properties[static_cast<std::size_t>(found)].type);
    }
    if (!(present[px] && present[py] && present[pz]))
        throw invalid_file(path_, 0, "the vertices have no properties x, y and z");
    body_.begin_element(element);
    has_normals_ = present[nx] && present[ny] && present[nz];
    has_colors_ = present[red] && present[green] && present[blue];
    has_uvs_ = present[tu] && present[tv];
    soup_.points.reserve(element.count);
    for (std::uint64_t row = 0; row < element.count; ++row) {
        body_.begin_row(row);
        for (std::size_t i = 0; i < slot_of.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            if (property.is_list)
                skip(property);
            else if (slot_of[i] == no_slot)
                body_.number(property.type);
            else
                values[slot_of[i]] = body_.number(property.type) * scales[slot_of[i]];
        }
        push_vertex(values);
        body_.end_row();
    }
}

template <typename Body>
void PlyParser<Body>::push_vertex(const std::array<double, slot_count>& values) {
    for (const Slot slot : {px, py, pz})
        if (!(std::abs(values[slot]) <= largest_coordinate))
            body_.fail("a coordinate is not a finite number of at most 1e100");
    soup_.points.emplace_back(values[px], values[py], values[pz]);
    if (has_normals_) soup_.normals.values.emplace_back(values[nx], values[ny], values[nz]);
    if (has_colors_)
        soup_.colors.values.push_back(
            linear_color(values[red], values[green], values[blue], values[alpha]));
    if (has_uvs_) soup_.uvs.values.emplace_back(values[tu], 1.0 - values[tv]);  // PLY's v points up
}

template <typename Body>
int PlyParser<Body>::require_list(const PlyElement& element) {
    const int list = element.find({"vertex_indices", "vertex_index"});
    if (list < 0 || !element.properties[static_cast<std::size_t>(list)].is_list ||
        is_float(element.properties[static_cast<std::size_t>(list)].type))
        throw invalid_file(path_, 0,
                           fmt::format("'{}' has no list of whole numbers named vertex_indices",
                                       printable(element.name)));
    return list;
}

template <typename Body>
void PlyParser<Body>::parse_faces(const PlyElement& element) {
    if (element.count == 0) return;
    const auto corners = static_cast<std::size_t>(require_list(element));
    const int wedges = element.find({"texcoord"});
    soup_.corners.reserve(3 * element.count);
    for (std::uint64_t row = 0; row < element.count; ++row) {
        body_.begin_row(row);
        face_begin_ = soup_.corners.size();
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            if (i == corners)
                parse_corners(property);
            else if (static_cast<int>(i) == wedges && property.is_list)
                parse_wedge_uvs(property);
            else
                skip(property);
        }
        end_face();
        body_.end_row();
    }
}

template <typename Body>
std::uint32_t PlyParser<Body>::checked(std::int64_t index) {
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count_)
        body_.fail(fmt::format("vertex {} is used, but the file has {} vertices (the first is 0)",
                               index, vertex_count_));
    return static_cast<std::uint32_t>(index);
}

template <typename Body>
void PlyParser<Body>::parse_corners(const PlyProperty& property) {
    const std::uint64_t size = body_.list_length(property.count_type, property.type);
    if (size < 3) body_.fail(fmt::format("a face needs at least 3 corners, this one has {}", size));
    for (std::uint64_t i = 0; i < size; ++i)
        soup_.corners.push_back(checked(body_.integer(property.type)));
    if (soup_.corners.size() >= no_index) body_.fail("too many face corners");
}

template <typename Body>
void PlyParser<Body>::parse_wedge_uvs(const PlyProperty& property) {
    const std::uint64_t size = body_.list_length(property.count_type, property.type);
    wedge_.clear();
    for (std::uint64_t i = 0; i < size; ++i) wedge_.push_back(body_.number(property.type));
}

template <typename Body>
void PlyParser<Body>::end_face() {
    const std::size_t size = soup_.corners.size() - face_begin_;
    soup_.end_face(size);
    if (wedge_.size() == 2 * size) {
        wedge_uvs_.of_corner.resize(face_begin_, no_index);
        for (std::size_t i = 0; i < size; ++i) {
            wedge_uvs_.of_corner.push_back(static_cast<std::uint32_t>(wedge_uvs_.values.size()));
            wedge_uvs_.values.emplace_back(wedge_[2 * i], 1.0 - wedge_[2 * i + 1]);
        }
    }
    wedge_.clear();
}

template <typename Body>
void PlyParser<Body>::parse_strips(const PlyElement& element) {
    const auto corners = static_cast<std::size_t>(require_list(element));
    for (std::uint64_t row = 0; row < element.count; ++row) {
        body_.begin_row(row);
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            if (i != corners) {
                skip(property);
                continue;
            }
            const std::uint64_t size = body_.list_length(property.count_type, property.type);
            strip_.clear();
            for (std::uint64_t k = 0; k < size; ++k)
                push_strip_corner(body_.integer(property.type));
        }
        body_.end_row();
    }
}

// Appends the triangle that the corner completes; -1 starts a new strip. Every second triangle of a
// strip is wound the other way.
template <typename Body>
void PlyParser<Body>::push_strip_corner(std::int64_t index) {
    if (index == -1) return strip_.clear();
    strip_.push_back(checked(index));
    const std::size_t n = strip_.size();
    if (n < 3) return;
    const std::uint32_t a = strip_[n - 3], b = strip_[n - 2], c = strip_[n - 1];
    if (a == b || b == c || c == a) {
        ++stitches_;
        return;
    }
    const bool odd = n % 2 == 0;
    soup_.corners.insert(soup_.corners.end(), {a, odd ? c : b, odd ? b : c});
    if (soup_.corners.size() >= no_index) body_.fail("too many face corners");
    soup_.end_face(3);
}

template <typename Body>
void PlyParser<Body>::skip(const PlyElement& element) {
    for (std::uint64_t row = 0; row < element.count; ++row) {
        body_.begin_row(row);
        for (const PlyProperty& property : element.properties) skip(property);
        body_.end_row();
    }
    soup_.notes.ignored_elements += element.count;
}

template <typename Body>
void PlyParser<Body>::skip(const PlyProperty& property) {
    const std::uint64_t values =
        property.is_list ? body_.list_length(property.count_type, property.type) : 1;
    for (std::uint64_t i = 0; i < values; ++i) body_.number(property.type);
}

template <typename Body>
void PlyParser<Body>::finish() {
    if (!wedge_uvs_.values.empty()) {
        wedge_uvs_.of_corner.resize(soup_.corners.size(), no_index);
        soup_.uvs = std::move(wedge_uvs_);
    }
    if (stitches_ > 0)
        soup_.notes.sentences.push_back(fmt::format(
            "{} triangles that only stitch strips together (repeated index) left out", stitches_));
}

}  // namespace

PolygonSoup parse_ply(const FileBuffer& file, const ReadOptions&) {
    const PlyHeader header = read_ply_header(file);
    if (header.format == PlyFormat::ascii) return PlyParser<PlyAsciiBody>(file, header).parse();
    return PlyParser<PlyBinaryBody>(file, header).parse();
}

}  // namespace burl
