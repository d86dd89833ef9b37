// Reads STL, ascii and binary. A binary file may begin with "solid" like an ascii one, so its
// length, which the triangle count fixes, decides first. Facet normals and attribute bytes are not
// kept: normals are made again from the welded surface, as for any format without them.
#include <algorithm>
#include <cmath>

#include "atlas/base/error.h"
#include "atlas/file/file_buffer.h"
#include "atlas/file/text_scanner.h"
#include "atlas/read/readers.h"

namespace burl {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t facet_bytes = 50;

bool is_word(std::string_view word, std::string_view lower) {
    return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    });
}

std::uint64_t announced_facets(const FileBuffer& file) {
    return load<std::uint32_t>(&file.bytes[80], big_endian_machine);
}

bool looks_like_text(const FileBuffer& file) {
    std::string_view head = file.text().substr(0, 1024);
    if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
    if (head.find('\0') != std::string_view::npos) return false;
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && is_word(head.substr(first, 5), "solid");
}

bool is_binary(const FileBuffer& file) {
    if (file.size >= header_bytes &&
        file.size == header_bytes + facet_bytes * announced_facets(file))
        return true;
    return !looks_like_text(file);
}

PolygonSoup parse_binary(const FileBuffer& file) {
    if (file.size < header_bytes)
        throw invalid_file(file.path, 0,
                           "this is neither an ascii STL nor long enough for a binary one");
    const std::uint64_t facets = announced_facets(file);
    const std::uint64_t room = (file.size - header_bytes) / facet_bytes;
    if (facets > room)
        throw invalid_file(
            file.path, 0,
            fmt::format("the file announces {} triangles, but is cut off after {}", facets, room));
    if (3 * facets >= no_index) throw invalid_file(file.path, 0, "too many triangles");
    PolygonSoup soup;
    soup.points.resize(3 * facets);
    soup.corners.resize(3 * facets);
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
        const char* bytes = &file.bytes[header_bytes + i / 3 * facet_bytes + 12 + i % 3 * 12];
        for (int k = 0; k < 3; ++k) {
            const float value = load<float>(bytes + 4 * k, big_endian_machine);
            if (!std::isfinite(value))
                throw invalid_file(file.path, 0,
                                   fmt::format("triangle {} has a coordinate that is not a finite "
                                               "number (the first triangle is 0)",
                                               i / 3));
            soup.points[i][k] = value;
        }
        soup.corners[i] = static_cast<std::uint32_t>(i);
    }
    if (const std::size_t rest = file.size - header_bytes - facets * facet_bytes; rest > 0)
        soup.notes.sentences.push_back(
            fmt::format("{} bytes after the last triangle ignored", rest));
    return soup;
}

class AsciiStlParser {
  public:
    explicit AsciiStlParser(const FileBuffer& file) : in_(file, false, text_begin(file)) {
        soup_.points.reserve(file.size / 80);
    }

    PolygonSoup parse() {
        while (in_.more()) parse_statement();
        if (in_loop_ || in_facet_) in_.fail("the file ends inside a facet");
        return std::move(soup_);
    }

  private:
    void parse_statement() {
        const std::string_view word = in_.word();
        if (is_word(word, "vertex")) return parse_vertex();
        if (is_word(word, "outer")) return begin_loop();
        if (is_word(word, "endloop")) return end_loop();
        if (is_word(word, "facet")) return begin_facet();
        if (is_word(word, "endfacet")) return set(in_facet_, false, "endfacet");
        if (!is_word(word, "solid") && !is_word(word, "endsolid"))
            in_.fail(fmt::format("'{}' is no STL keyword", printable(word)));
        in_.next_line();  // the rest is the solid's name
    }

    void set(bool& state, bool now, const char* keyword) {
        if (state == now) in_.fail(fmt::format("'{}' out of place", keyword));
        state = now;
    }

    void begin_facet() {
        set(in_facet_, true, "facet");
        if (TextScanner ahead = in_; is_word(ahead.word(), "normal")) {
            for (int i = 0; i < 3; ++i) ahead.word();  // often nan, so not even read
            in_ = ahead;
        }
    }

    void begin_loop() {
        set(in_loop_, true, "outer loop");
        if (TextScanner ahead = in_; is_word(ahead.word(), "loop")) in_ = ahead;
    }

    void parse_vertex() {
        if (!in_loop_) in_.fail("a vertex outside of a loop");
        Vec3d p;
        p.x = in_.coordinate();
        p.y = in_.coordinate();
        p.z = in_.coordinate();
        soup_.corners.push_back(static_cast<std::uint32_t>(soup_.points.size()));
        soup_.points.push_back(p);
        ++loop_corners_;
    }

    void end_loop() {
        if (!in_loop_) in_.fail("'endloop' out of place");
        if (loop_corners_ < 3)
            in_.fail(fmt::format("a facet needs 3 corners, this one has {}", loop_corners_));
        soup_.end_face(loop_corners_);
        in_loop_ = false;
        loop_corners_ = 0;
    }

    TextScanner in_;
    PolygonSoup soup_;
    bool in_facet_ = false, in_loop_ = false;
    std::size_t loop_corners_ = 0;
};

}  // namespace

PolygonSoup parse_stl(const FileBuffer& file, const ReadOptions&) {
    return is_binary(file) ? parse_binary(file) : AsciiStlParser(file).parse();
}

}  // namespace burl
