#pragma once
// The layout of a PLY file (Turk 1994): a header with any elements with any properties, in any
// order, and the two kinds of body behind one interface, over which the reader is a template: rows
// of numbers in ascii lines, or in bytes of either order.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "atlas/base/error.h"
#include "atlas/file/file_buffer.h"
#include "atlas/file/text_scanner.h"

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

/// The rows of an ascii PLY, whose types do not matter: every number is a token.
class PlyAsciiBody {
  public:
    PlyAsciiBody(const FileBuffer& file, const PlyHeader& header)
        : in_(file, false, header.body_offset, header.body_line) {}

    /// Checks that the rows of `element` can fit into the rest of the file.
    void begin_element(const PlyElement& element) {
        // Each value takes a digit and a separator; the last separator may be missing.
        const std::uint64_t least = 2 * element.properties.size();
        element_ = &element;
        if (element.count > (in_.bytes_left() + 1) / least)
            in_.fail(
                fmt::format("the header announces {} rows of '{}', more than the rest of the file "
                            "can hold; it is cut off or damaged",
                            element.count, printable(element.name)));
    }
    void begin_row(std::uint64_t row) {
        if (!in_.more())
            in_.fail(fmt::format("the file ends after {} of {} rows of '{}'", row, element_->count,
                                 printable(element_->name)));
    }
    void end_row() { in_.next_line(); }

    double number(PlyType) { return in_.number("a number"); }
    std::int64_t integer(PlyType) { return in_.integer("a whole number"); }
    std::uint64_t list_length(PlyType, PlyType) {
        const std::int64_t length = in_.integer("the length of a list");
        // A caller may reserve this length, so the file must be able to hold it.
        if (length < 0 || static_cast<std::uint64_t>(length) > in_.bytes_left() / 2 + 1)
            in_.fail(fmt::format("a list of {} values does not fit into the file", length));
        return static_cast<std::uint64_t>(length);
    }
    [[noreturn]] void fail(const std::string& message) const { in_.fail(message); }

  private:
    TextScanner in_;
    const PlyElement* element_ = nullptr;
};

/// The rows of a binary PLY of either byte order.
class PlyBinaryBody {
  public:
    PlyBinaryBody(const FileBuffer& file, const PlyHeader& header)
        : path_(&file.path),
          at_(file.bytes.get() + header.body_offset),
          end_(file.bytes.get() + file.size),
          swapped_((header.format == PlyFormat::big_endian) != big_endian_machine) {}

    void begin_element(const PlyElement& element) {
        element_ = &element;
        row_ = 0;
        if (element.count > left() / element.least_binary_bytes())
            throw invalid_file(*path_, 0,
                               fmt::format("the header announces {} rows of '{}', more than the {} "
                                           "bytes left can hold; the file is cut off or damaged",
                                           element.count, printable(element.name), left()));
    }
    void begin_row(std::uint64_t row) { row_ = row; }
    void end_row() {}

    double number(PlyType type) {
        need(byte_size(type));
        const char* bytes = at_;
        at_ += byte_size(type);
        return decode(bytes, type);
    }
    std::int64_t integer(PlyType type) { return static_cast<std::int64_t>(number(type)); }
    std::uint64_t list_length(PlyType count_type, PlyType item_type) {
        const double length = number(count_type);
        if (length < 0.0) fail("a list has a negative length");
        if (length > static_cast<double>(left() / byte_size(item_type)))
            fail(fmt::format("a list of {:.0f} values does not fit into the file", length));
        return static_cast<std::uint64_t>(length);
    }
    [[noreturn]] void fail(const std::string& message) const {
        throw invalid_file(
            *path_, 0,
            fmt::format("{} {} (the first is 0): {}", printable(element_->name), row_, message));
    }

  private:
    std::uint64_t left() const { return static_cast<std::uint64_t>(end_ - at_); }
    void need(std::size_t bytes) const {
        if (left() < bytes) fail("the file is cut off here");
    }
    double decode(const char* bytes, PlyType type) const {
        switch (type) {
            case PlyType::i8:
                return load<std::int8_t>(bytes);
            case PlyType::u8:
                return load<std::uint8_t>(bytes);
            case PlyType::i16:
                return load<std::int16_t>(bytes, swapped_);
            case PlyType::u16:
                return load<std::uint16_t>(bytes, swapped_);
            case PlyType::i32:
                return load<std::int32_t>(bytes, swapped_);
            case PlyType::u32:
                return load<std::uint32_t>(bytes, swapped_);
            case PlyType::f32:
                return static_cast<double>(load<float>(bytes, swapped_));
            case PlyType::f64:
                break;
        }
        return load<double>(bytes, swapped_);
    }

    const std::string* path_;
    const char* at_;
    const char* end_;
    bool swapped_;
    const PlyElement* element_ = nullptr;
    std::uint64_t row_ = 0;
};

}  // namespace burl
