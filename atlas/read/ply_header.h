#pragma once
// The header of a PLY file: any elements with any properties, in any order (Turk 1994).
#include <cstdint>
#include <string>
#include <vector>

#include "atlas/file/file_buffer.h"

namespace burl {

/// Type of a property: a signed or unsigned integer or a float, with its number of bits.
enum class PlyType : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

/// Number of bytes of a value in a binary body.
constexpr std::size_t byte_size(PlyType type) {
    constexpr std::size_t sizes[]{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}
constexpr bool is_float(PlyType type) {
    return type == PlyType::f32 || type == PlyType::f64;
}

/// A scalar or list property of an element.
struct PlyProperty {
    std::string name;
    PlyType type = PlyType::f32;
    bool is_list = false;
    PlyType count_type = PlyType::u8;  ///< type of a list's length
};

/// A kind of element: `count` rows in the body, each with these properties in order.
struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of the first property with one of these names, or -1.
    int find(std::initializer_list<const char*> names) const;
    /// Smallest number of bytes of a row in a binary body (empty lists); 0 without properties.
    std::size_t least_binary_bytes() const;
};

enum class PlyFormat { ascii, little_endian, big_endian };

/// The format, the elements in order, and the place of the body.
struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t body_offset = 0;  ///< offset of the first byte after the end_header line
    std::size_t body_line = 1;    ///< line number of that byte, from 1
};

/// Parses the file's header. Throws Error(invalid_file) with the number of the wrong line.
PlyHeader read_ply_header(const FileBuffer& file);

}  // namespace burl
