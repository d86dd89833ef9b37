// Reads OFF and its relatives with colours (COFF), normals (NOFF), texture coordinates (STOFF) and
// any mix of them, as Geomview writes them. Vertices and faces stand one per line.
#include <array>

#include "atlas/base/error.h"
#include "atlas/base/srgb.h"
#include "atlas/file/text_scanner.h"
#include "atlas/read/readers.h"

namespace burl {
namespace {

class OffParser {
  public:
    explicit OffParser(const FileBuffer& file) : in_(file, false, text_begin(file)) {}

    PolygonSoup parse() {
        if (!in_.more()) in_.fail("the file holds nothing but comments");
        parse_header();
        parse_counts();
        for (std::uint64_t i = 0; i < vertices_; ++i) parse_vertex(i);
        for (std::uint64_t i = 0; i < faces_; ++i) parse_face(i);
        finish();
        return std::move(soup_);
    }

  private:
    void parse_header();
    void parse_counts();
    void parse_vertex(std::uint64_t number);
    void parse_color();
    void parse_face(std::uint64_t number);
    void finish();

    TextScanner in_;
    PolygonSoup soup_;
    bool has_normals_ = false, has_colors_ = false, has_uvs_ = false;
    std::uint64_t vertices_ = 0, faces_ = 0;
    std::uint64_t lines_with_extras_ = 0, colored_faces_ = 0;
    bool colors_are_bytes_ = false;
};

bool starts_number(char c) {
    return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
}

// Parses [ST][C][N][4][n]OFF [BINARY]; old files leave the word out.
void OffParser::parse_header() {
    TextScanner ahead = in_;
    std::string_view word = ahead.word();
    if (starts_number(word.front()) && !word.ends_with("OFF")) return;
    const std::string whole = printable(word);
    const auto take = [&](std::string_view prefix) {
        const bool there = word.starts_with(prefix);
        if (there) word.remove_prefix(prefix.size());
        return there;
    };
    has_uvs_ = take("ST");
    has_colors_ = take("C");
    has_normals_ = take("N");
    if (word == "4OFF" || word == "nOFF" || word == "4nOFF")
        throw Error(ExitCode::unsupported,
                    fmt::format("{}:{}: {} holds points of more than three dimensions", in_.path(),
                                in_.line(), whole));
    if (word != "OFF") in_.fail(fmt::format("expected OFF, found '{}'", whole));
    in_ = ahead;
    TextScanner next = in_;
    if (next.word() == "BINARY")
        throw Error(ExitCode::unsupported,
                    fmt::format("{}:{}: binary OFF is not supported; save it "
                                "as text",
                                in_.path(), in_.line()));
}

void OffParser::parse_counts() {
    if (!in_.more()) in_.fail("expected the numbers of vertices and faces, but the file ends here");
    const std::int64_t vertices = in_.integer("the number of vertices");
    const std::int64_t faces = in_.integer("the number of faces");
    in_.next_line();  // the number of edges, which nobody needs and some leave out
    if (vertices < 0 || faces < 0) in_.fail("a number of vertices or faces is negative");
    // A vertex takes at least "0 0 0\n", a face "3 0 0 0\n"; the last line end may be missing.
    const std::uint64_t room = in_.bytes_left() + 1;
    vertices_ = static_cast<std::uint64_t>(vertices);
    faces_ = static_cast<std::uint64_t>(faces);
    if (vertices_ > room / 6 || faces_ > room / 8)
        in_.fail(
            fmt::format("the file announces {} vertices and {} faces, more than its {} bytes can "
                        "hold; it is cut off or damaged",
                        vertices, faces, room - 1));
    if (vertices_ >= no_index) in_.fail("too many vertices");
    soup_.points.reserve(vertices_);
    soup_.corners.reserve(3 * faces_);
}

void OffParser::parse_vertex(std::uint64_t number) {
    if (!in_.more())
        in_.fail(fmt::format("the file ends after {} of {} vertices", number, vertices_));
    Vec3d p;
    p.x = in_.coordinate();
    p.y = in_.coordinate();
    p.z = in_.coordinate();
    soup_.points.push_back(p);
    if (has_normals_) {
        const double x = in_.number("a normal");
        const double y = in_.number("a normal");
        const double z = in_.number("a normal");
        soup_.normals.values.emplace_back(x, y, z);
    }
    if (has_colors_) parse_color();
    if (has_uvs_) {
        const double s = in_.number("a texture coordinate");
        const double t = in_.number("a texture coordinate");
        soup_.uvs.values.emplace_back(s, 1.0 - t);
    }
    lines_with_extras_ += in_.more_on_line();
    in_.next_line();
}

// Parses r g b [a]; the alpha may be left out where no texture coordinate follows.
void OffParser::parse_color() {
    std::array<double, 4> color{0.0, 0.0, 0.0, -1.0};
    for (std::size_t k = 0; k < 3; ++k) color[k] = in_.number("a colour");
    if (has_uvs_ || in_.more_on_line()) color[3] = in_.number("a colour");
    for (const double value : color) colors_are_bytes_ |= value > 1.0;
    soup_.colors.values.emplace_back(color[0], color[1], color[2], color[3]);
}

void OffParser::parse_face(std::uint64_t number) {
    if (!in_.more()) in_.fail(fmt::format("the file ends after {} of {} faces", number, faces_));
    const std::int64_t size = in_.integer("the number of a face's corners");
    if (size < 3) in_.fail(fmt::format("a face needs at least 3 corners, this one has {}", size));
    for (std::int64_t i = 0; i < size; ++i) {
        in_.more();  // long faces may go on in the next line
        const std::int64_t index = in_.integer("a vertex index");
        if (index < 0 || static_cast<std::uint64_t>(index) >= vertices_)
            in_.fail(
                fmt::format("the face uses vertex {}, but the file has {} vertices (the first "
                            "is 0)",
                            index, vertices_));
        soup_.corners.push_back(static_cast<std::uint32_t>(index));
    }
    if (soup_.corners.size() >= no_index) in_.fail("too many face corners");
    soup_.end_face(static_cast<std::size_t>(size));
    colored_faces_ += in_.more_on_line();
    in_.next_line();
}

void OffParser::finish() {
    const double scale = colors_are_bytes_ ? 1.0 / 255.0 : 1.0;
    for (Vec4f& color : soup_.colors.values)
        color = linear_color(color.r * scale, color.g * scale, color.b * scale,
                             color.a < 0.0f ? 1.0 : color.a * scale);
    auto& say = soup_.notes.sentences;
    if (lines_with_extras_ > 0)
        say.push_back(fmt::format("{} vertices carry values the header does not announce; ignored",
                                  lines_with_extras_));
    if (colored_faces_ > 0)
        say.push_back(fmt::format("the colours of {} faces are ignored", colored_faces_));
    if (in_.more())
        say.push_back(fmt::format("text after the last face (line {}) ignored", in_.line()));
}

}  // namespace

PolygonSoup parse_off(const FileBuffer& file, const ReadOptions&) {
    return OffParser(file).parse();
}

}  // namespace burl
