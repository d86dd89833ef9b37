#pragma once
// What a PLY file says about itself: any elements with any properties, in any order (Turk 1994).
#include <cstdint>
#include <string>
#include <vector>

#include "atlas/file/file_buffer.h"

namespace burl {

enum class PlyType : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

constexpr std::size_t byte_size(PlyType type) {
    constexpr std::size_t sizes[]{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}
constexpr bool is_float(PlyType type) {
    return type == PlyType::f32 || type == PlyType::f64;
}

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::f32;
    bool is_list = false;
    PlyType count_type = PlyType::u8;  ///< of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of the property with one of these names, or -1.
    int find(std::initializer_list<const char*> names) const;
    /// Fewest bytes one row can take in a binary body; 0 without properties.
    std::size_t least_binary_bytes() const;
};

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t body_offset = 0;  ///< first byte after the end_header line
    std::size_t body_line = 1;    ///< its line number, from 1
};

/// Throws Error(invalid_file) with the line of what is wrong.
PlyHeader read_ply_header(const FileBuffer& file);

}  // namespace burl
