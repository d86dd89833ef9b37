// Parses PLY headers line by line.
#include "atlas/read/ply_file.h"

#include <array>
#include <optional>
#include <utility>

#include "atlas/base/error.h"
#include "atlas/file/text_scanner.h"

namespace burl {
namespace {

constexpr std::size_t most_elements = 1000;  // a sane file has two or three

std::optional<PlyType> type_named(std::string_view name) {
    using enum PlyType;
    static constexpr std::array<std::pair<const char*, PlyType>, 16> names{{{"char", i8},
                                                                            {"uchar", u8},
                                                                            {"short", i16},
                                                                            {"ushort", u16},
                                                                            {"int", i32},
                                                                            {"uint", u32},
                                                                            {"float", f32},
                                                                            {"double", f64},
                                                                            {"int8", i8},
                                                                            {"uint8", u8},
                                                                            {"int16", i16},
                                                                            {"uint16", u16},
                                                                            {"int32", i32},
                                                                            {"uint32", u32},
                                                                            {"float32", f32},
                                                                            {"float64", f64}}};
    for (const auto& [known, type] : names)
        if (name == known) return type;
    return std::nullopt;
}

PlyType parse_type(TextScanner& in) {
    const std::string_view name = in.word();
    const std::optional<PlyType> type = type_named(name);
    if (!type) in.fail(fmt::format("'{}' is no PLY type", printable(name)));
    return *type;
}

PlyFormat parse_format(TextScanner& in) {
    const std::string_view name = in.word();
    if (name == "ascii") return PlyFormat::ascii;
    if (name == "binary_little_endian") return PlyFormat::little_endian;
    if (name == "binary_big_endian") return PlyFormat::big_endian;
    in.fail(fmt::format("unknown PLY format '{}'", printable(name)));
}

PlyElement parse_element(TextScanner& in, const PlyHeader& header) {
    PlyElement element;
    element.name = in.word();
    if (element.name.empty()) in.fail("an element without a name");
    const std::int64_t count = in.integer("the number of elements");
    if (count < 0) in.fail("the number of elements is negative");
    element.count = static_cast<std::uint64_t>(count);
    for (const PlyElement& other : header.elements)
        if (other.name == element.name)
            in.fail(fmt::format("element '{}' is declared twice", printable(element.name)));
    return element;
}

PlyProperty parse_property(TextScanner& in) {
    PlyProperty property;
    TextScanner ahead = in;
    if (ahead.word() == "list") {
        in = ahead;
        property.is_list = true;
        property.count_type = parse_type(in);
        if (is_float(property.count_type)) in.fail("the length of a list cannot be a float");
    }
    property.type = parse_type(in);
    property.name = in.word();
    if (property.name.empty()) in.fail("a property without a name");
    return property;
}

}  // namespace

int PlyElement::find(std::initializer_list<const char*> names) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
        for (const char* wanted : names)
            if (properties[i].name == wanted) return static_cast<int>(i);
    return -1;
}

std::size_t PlyElement::least_binary_bytes() const {
    std::size_t bytes = 0;
    for (const PlyProperty& p : properties) bytes += byte_size(p.is_list ? p.count_type : p.type);
    return bytes;
}

PlyHeader read_ply_header(const FileBuffer& file) {
    TextScanner in(file, false, text_begin(file));
    if (in.word() != "ply") in.fail("a PLY file must begin with 'ply'");
    PlyHeader header;
    bool has_format = false;
    while (in.next_line()) {
        const std::string_view keyword = in.word();
        if (keyword == "format") {
            header.format = parse_format(in);
            has_format = true;
        } else if (keyword == "element") {
            if (header.elements.size() == most_elements) in.fail("too many elements");
            header.elements.push_back(parse_element(in, header));
        } else if (keyword == "property") {
            if (header.elements.empty()) in.fail("a property before the first element");
            header.elements.back().properties.push_back(parse_property(in));
        } else if (keyword == "end_header") {
            if (!has_format) in.fail("the header names no format");
            in.next_line();
            header.body_offset = in.offset();
            header.body_line = in.line();
            return header;
        } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
            in.fail(fmt::format("'{}' is no PLY header keyword", printable(keyword)));
        }
    }
    in.fail("the header does not end; 'end_header' is missing");
}

}  // namespace burl
