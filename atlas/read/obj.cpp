// Reads the surface of a Wavefront OBJ: v (with colours), vt, vn, f, and objects (o) as parts.
// Faces may refer to vertices that come later in the file, so ranges are checked at the end; a
// second pass then finds the line.
#include <algorithm>
#include <array>
#include <set>

#include "atlas/base/error.h"
#include "atlas/base/srgb.h"
#include "atlas/file/text_scanner.h"
#include "atlas/read/readers.h"

namespace burl {
namespace {

/// The three lists that a face corner indexes.
enum Kind { position_list, texture_list, normal_list };
constexpr std::array<const char*, 3> kind_names{"vertex", "texture coordinate", "normal"};
constexpr std::array<const char*, 3> kind_plurals{"vertices", "texture coordinates", "normals"};

using Counts = std::array<std::size_t, 3>;

class ObjParser {
  public:
    /// `limits` are the numbers of elements that the file holds, or no_index while they are
    /// unknown.
    ObjParser(const FileBuffer& file, const Counts& limits)
        : in_(file, true, text_begin(file)), limits_(limits) {
        soup_.points.reserve(file.size / 80);
        soup_.corners.reserve(file.size / 13);
    }

    void parse() {
        do {
            parse_line();
        } while (in_.next_line());
    }
    bool in_range() const {
        for (int k = 0; k < 3; ++k)
            if (beyond_[k] > count(static_cast<Kind>(k))) return false;
        return true;
    }
    Counts counts() const {
        return {count(position_list), count(texture_list), count(normal_list)};
    }
    PolygonSoup finish();

  private:
    std::size_t count(Kind kind) const {
        return kind == position_list  ? soup_.points.size()
               : kind == texture_list ? soup_.uvs.values.size()
                                      : soup_.normals.values.size();
    }
    void parse_line();
    void parse_vertex();
    void parse_texture();
    void parse_normal();
    void parse_face();
    void parse_corner();
    void parse_object();
    void end_object();
    void parse_other(std::string_view keyword);
    std::uint32_t resolve(std::int64_t index, Kind kind);
    template <typename Value>
    void push_reference(SoupAttribute<Value>& attribute, std::uint32_t index);

    TextScanner in_;
    Counts limits_;
    Counts beyond_{};  ///< largest index used of each kind, plus 1
    PolygonSoup soup_;
    std::string object_;  ///< the name of the object that faces are of
    std::set<std::string> materials_, groups_;
    std::uint64_t unknown_lines_ = 0;
    std::size_t first_unknown_line_ = 0;
};

void ObjParser::parse_line() {
    const std::string_view keyword = in_.word();
    if (keyword.empty()) return;
    if (keyword == "v")
        parse_vertex();
    else if (keyword == "f" || keyword == "fo")
        parse_face();
    else if (keyword == "vt")
        parse_texture();
    else if (keyword == "vn")
        parse_normal();
    else if (keyword == "o")
        parse_object();
    else
        parse_other(keyword);
}

// Parses v x y z, v x y z w, v x y z r g b or v x y z w r g b.
void ObjParser::parse_vertex() {
    if (soup_.points.size() >= no_index - 1) in_.fail("too many vertices");
    Vec3d p;
    p.x = in_.coordinate();
    p.y = in_.coordinate();
    p.z = in_.coordinate();
    soup_.points.push_back(p);
    std::array<double, 4> more{};
    std::size_t extra = 0;
    while (in_.more_on_line()) {
        const double value = in_.number("a number");
        if (extra < more.size()) more[extra] = value;
        ++extra;
    }
    auto& colors = soup_.colors.values;
    if (extra == 3 || extra == 4) {
        colors.resize(soup_.points.size() - 1, Vec4f(1.0f));
        colors.push_back(linear_color(more[extra - 3], more[extra - 2], more[extra - 1]));
    } else if (!colors.empty()) {
        colors.emplace_back(1.0f);
    }
}

void ObjParser::parse_texture() {
    const double u = in_.number("a texture coordinate");
    const double v = in_.more_on_line() ? in_.number("a texture coordinate") : 0.0;
    soup_.uvs.values.emplace_back(u, 1.0 - v);  // OBJ's v points up
}

void ObjParser::parse_normal() {
    const double x = in_.number("a normal");
    const double y = in_.number("a normal");
    const double z = in_.number("a normal");
    soup_.normals.values.emplace_back(x, y, z);
}

void ObjParser::parse_face() {
    const std::size_t first = soup_.corners.size();
    while (in_.more_on_line()) parse_corner();
    const std::size_t size = soup_.corners.size() - first;
    if (size < 3) in_.fail(fmt::format("a face needs at least 3 corners, this one has {}", size));
    if (soup_.corners.size() >= no_index) in_.fail("too many face corners");
    soup_.end_face(size);
}

// Parses v, v/vt, v//vn or v/vt/vn.
void ObjParser::parse_corner() {
    std::int64_t index = 0;
    std::uint32_t uv = no_index, vn = no_index;
    if (!in_.raw_integer(index)) in_.integer("a vertex index");
    const std::uint32_t point = resolve(index, position_list);
    if (in_.take('/')) {
        if (in_.raw_integer(index)) uv = resolve(index, texture_list);
        if (in_.take('/') && in_.raw_integer(index)) vn = resolve(index, normal_list);
    }
    if (!in_.at_token_end())
        in_.fail(
            fmt::format("cannot read a face corner; '{}' is left over", printable(in_.word())));
    push_reference(soup_.uvs, uv);
    push_reference(soup_.normals, vn);
    soup_.corners.push_back(point);
}

/// Sets the attribute's index of the corner that is pushed next; of_corner stays empty until the
/// first corner has this attribute.
template <typename Value>
void ObjParser::push_reference(SoupAttribute<Value>& attribute, std::uint32_t index) {
    if (index == no_index && attribute.of_corner.empty()) return;
    attribute.of_corner.resize(soup_.corners.size(), no_index);
    attribute.of_corner.push_back(index);
}

/// Index from 0 for OBJ's numbering (1 is the first, -1 the latest). Throws Error when it can never
/// be in range.
std::uint32_t ObjParser::resolve(std::int64_t index, Kind kind) {
    const auto present = static_cast<std::int64_t>(count(kind));
    const std::int64_t from_zero = index > 0 ? index - 1 : present + index;
    const bool usable = index != 0 && from_zero >= 0 && from_zero < std::int64_t{no_index};
    if (!usable || static_cast<std::size_t>(from_zero) >= limits_[kind]) {
        const bool known = limits_[kind] != no_index;
        const std::size_t held = known ? limits_[kind] : count(kind);
        in_.fail(fmt::format("the face uses {} {}, but {} {} {} (the first is 1)", kind_names[kind],
                             index, known ? "the file has" : "up to here there are", held,
                             kind_plurals[kind]));
    }
    beyond_[kind] = std::max(beyond_[kind], static_cast<std::size_t>(from_zero) + 1);
    return static_cast<std::uint32_t>(from_zero);
}

// An object goes on to the next; what stands before the first has no name. Objects without faces
// are no parts.
void ObjParser::parse_object() {
    end_object();
    object_ = in_.rest_of_line();
}

void ObjParser::end_object() {
    const std::size_t first =
        soup_.parts.empty() ? 0 : soup_.parts.back().first_face + soup_.parts.back().face_count;
    const std::size_t end = soup_.face_count();
    if (end > first) soup_.parts.push_back({object_, first, end - first});
}

void ObjParser::parse_other(std::string_view keyword) {
    static constexpr std::array drawn{"p", "l", "curv", "curv2", "surf"};
    static constexpr std::array silent{
        "g",     "s",        "mg",       "usemtl", "mtllib", "usemap",     "maplib",    "vp",
        "deg",   "bmat",     "step",     "cstype", "parm",   "trim",       "hole",      "scrv",
        "sp",    "end",      "con",      "bevel",  "lod",    "shadow_obj", "trace_obj", "ctech",
        "stech", "c_interp", "d_interp", "call",   "csh"};
    if (keyword == "usemtl" || keyword == "g")
        if (const std::string name = in_.rest_of_line(); !name.empty())
            (keyword == "g" ? groups_ : materials_).insert(name);
    if (std::find(drawn.begin(), drawn.end(), keyword) != drawn.end()) {
        ++soup_.notes.ignored_elements;
    } else if (std::find(silent.begin(), silent.end(), keyword) == silent.end()) {
        if (unknown_lines_++ == 0) first_unknown_line_ = in_.line();
    }
}

PolygonSoup ObjParser::finish() {
    end_object();
    soup_.notes.materials = materials_.size();
    soup_.notes.groups = groups_.size();
    if (unknown_lines_ > 0)
        soup_.notes.sentences.push_back(
            fmt::format("{} lines with an unknown keyword ignored, the "
                        "first is line {}",
                        unknown_lines_, first_unknown_line_));
    const auto settle = [&](auto& attribute) {  // drops unused lists, completes used ones
        if (attribute.of_corner.empty()) attribute.values.clear();
        if (!attribute.values.empty()) attribute.of_corner.resize(soup_.corners.size(), no_index);
    };
    settle(soup_.uvs);
    settle(soup_.normals);
    return std::move(soup_);
}

}  // namespace

PolygonSoup parse_obj(const FileBuffer& file, const ReadOptions&) {
    ObjParser parser(file, {no_index, no_index, no_index});
    parser.parse();
    if (!parser.in_range()) {
        ObjParser finder(file, parser.counts());
        finder.parse();  // throws at the first line that is out of range
    }
    return parser.finish();
}

}  // namespace burl
