#include "atlas/read/obj_source.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "atlas/base/error.h"
#include "atlas/base/glob.h"
#include "atlas/file/text_scanner.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/readers.h"

namespace burl {

namespace {

/// The keywords of free-form curves and surfaces.
constexpr std::array<std::string_view, 16> free_form{
    "vp",   "deg",  "bmat", "step", "cstype", "curv", "curv2", "surf",
    "parm", "trim", "hole", "scrv", "sp",     "end",  "con",   "cdc"};

/// The line without blanks at its end, and without a `\` that joins an empty line to it, or ends
/// the file.
std::string_view without_end(std::string_view line) {
    while (true) {
        std::size_t size = line.size();
        while (size > 0 && static_cast<unsigned char>(line[size - 1]) <= ' ') --size;
        const std::string_view blanks = line.substr(size);
        line = line.substr(0, size);
        const bool joins = blanks.empty() || blanks.starts_with('\n') || blanks.starts_with("\r\n");
        if (!joins || !line.ends_with('\\')) return line;
        line.remove_suffix(1);
    }
}

/// Reads the lines of an OBJ whose faces have been parsed without error.
class LineReader {
  public:
    explicit LineReader(ObjSource& source)
        : source_(source), in_(source.file, true, text_begin(source.file)) {}

    void read() {
        for (bool more = true; more;) {
            const std::size_t begin = in_.offset();
            const std::string_view keyword = in_.word();
            const bool named = keyword == "usemtl" || keyword == "mtllib";
            const std::string rest = named ? in_.rest_of_line() : std::string();
            element_.clear();
            if (keyword == "p" || keyword == "l") read_element();
            more = in_.next_line();
            const std::size_t end = more ? in_.offset() - 1 : source_.file.size;
            if (!keyword.empty())
                add(keyword, rest, source_.file.text().substr(begin, end - begin));
        }
    }

  private:
    void add(std::string_view keyword, const std::string& rest, std::string_view line);
    void read_element();
    std::uint32_t number(std::size_t count);
    std::uint32_t material(const std::string& name);

    ObjSource& source_;
    TextScanner in_;
    std::vector<std::array<std::uint32_t, 2>> element_;
    std::uint32_t material_ = no_index, face_ = 0;
    std::unordered_map<std::string, std::uint32_t> materials_;
};

void LineReader::add(std::string_view keyword, const std::string& rest, std::string_view line) {
    line = without_end(line);
    if (keyword == "v") {
        source_.points.push_back(line);
    } else if (keyword == "vt") {
        source_.uvs.push_back(line);
    } else if (keyword == "vn") {
        source_.normals.push_back(line);
    } else if (keyword == "f" || keyword == "fo") {
        source_.material_of_face.push_back(material_);
        source_.statements.push_back({ObjStatement::Kind::face, face_++});
    } else if (keyword == "p" || keyword == "l") {
        source_.statements.push_back(
            {ObjStatement::Kind::element, 0, std::string(keyword), element_});
    } else if (keyword == "usemtl") {
        material_ = material(rest);
    } else if (keyword == "mtllib") {
        source_.libraries.push_back(rest);
    } else if (std::ranges::find(free_form, keyword) != free_form.end()) {
        ++source_.left_out;
    } else {
        source_.statements.push_back({ObjStatement::Kind::text, 0, as_one_line(line)});
    }
}

/// Reads the corners of a point or line element up to the first that is none.
void LineReader::read_element() {
    while (in_.more_on_line()) {
        const std::uint32_t point = number(source_.points.size());
        if (point == no_index) return;
        const bool has_uv = in_.take('/');
        element_.push_back({point, has_uv ? number(source_.uvs.size()) : no_index});
    }
}

/// The number from 0 that stands here in OBJ's numbering; no_index where there is none.
std::uint32_t LineReader::number(std::size_t count) {
    std::int64_t value = 0;
    if (!in_.raw_integer(value)) return no_index;
    const std::int64_t from_zero = value > 0 ? value - 1 : std::int64_t(count) + value;
    const bool usable = value != 0 && from_zero >= 0 && from_zero < std::int64_t{no_index};
    return usable ? std::uint32_t(from_zero) : no_index;
}

std::uint32_t LineReader::material(const std::string& name) {
    const auto [known, fresh] =
        materials_.try_emplace(name, std::uint32_t(source_.materials.size()));
    if (fresh) source_.materials.emplace_back(name);
    return known->second;
}

std::vector<std::size_t> first_corners_of(const PolygonSoup& faces) {
    std::vector<std::size_t> first{0};
    for (std::size_t face = 0; face < faces.face_count(); ++face)
        first.push_back(first.back() + (faces.face_sizes.empty() ? 3 : faces.face_sizes[face]));
    return first;
}

/// The names as a sentence lists them, the first twenty.
std::string list_of(const std::vector<std::string>& names) {
    if (names.empty()) return "none";
    std::string list;
    for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 20); ++i)
        list += (i == 0 ? "" : ", ") + printable(names[i]);
    return names.size() > 20 ? list + ", ..." : list;
}

}  // namespace

ObjSource read_obj_source(FileBuffer file) {
    ObjSource source;
    source.file = std::move(file);
    source.faces = parse_obj(source.file);
    source.first_corner = first_corners_of(source.faces);
    LineReader(source).read();
    return source;
}

std::vector<char> faces_of_materials(const ObjSource& source,
                                     const std::vector<std::string>& patterns) {
    std::vector<std::string> names = source.materials;
    names.emplace_back("no material");  // of faces before the first usemtl
    const bool nameless =
        std::ranges::find(source.material_of_face, no_index) != source.material_of_face.end();
    std::vector<char> chosen(names.size(), 0);
    for (const std::string& pattern : patterns) {
        bool any = false;
        for (std::size_t i = 0; i + !nameless < names.size(); ++i)
            if (matches_glob(names[i], pattern)) chosen[i] = any = true;
        if (!any)
            throw Error(ExitCode::usage,
                        fmt::format("--material: {} has no material like \"{}\"; it has {}",
                                    source.file.path, pattern, list_of(source.materials)));
    }
    std::vector<char> faces;
    for (const std::uint32_t material : source.material_of_face)
        faces.push_back(chosen[std::min<std::size_t>(material, names.size() - 1)]);
    return faces;
}

std::vector<std::uint32_t> points_of_corners(const ObjSource& source, const Mesh& mesh) {
    PolygonSoup soup = source.faces;
    const std::vector<std::uint32_t> cut = corners_of_triangles(soup);
    std::vector<std::uint32_t> points(source.faces.corners.size(), no_index);
    std::size_t t = 0, corner = 0;
    for (std::uint32_t face = 0; face + 1 < source.first_corner.size(); ++face)
        for (std::size_t i = 0; i + 2 < source.face_size(face); ++i, corner += 3) {
            if (t == mesh.triangles.size() || mesh.source_faces[t] != face) continue;
            for (std::size_t k = 0; k < 3; ++k)
                points[cut.empty() ? corner + k : cut[corner + k]] = mesh.triangles[t][k];
            ++t;
        }
    if (t != mesh.triangles.size())
        throw Error(
            ExitCode::runtime,
            fmt::format("{}: the file has changed while it was used; try again", source.file.path));
    return points;
}

}  // namespace burl
