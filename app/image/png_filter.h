#pragma once
// The row filters of PNG (W3C, "PNG Specification (Third Edition)", section 9), which store how
// bytes differ from their neighbours.
#include <cstdint>
#include <span>
#include <vector>

namespace burl {

/// The filter of rows: one of PNG's own for all of them, or for each row the one of sub to paeth
/// whose differences have the least sum.
enum class PngFilter : std::uint8_t { none, sub, up, average, paeth, adaptive };

/// Filters rows that follow one another.
class RowFilter {
  public:
    /// `stride` bytes make a row, `pixel` bytes a pixel. The row above the first has zeros.
    RowFilter(std::size_t stride, std::size_t pixel);

    /// The next row's bytes, to be filled in before pass() or add().
    std::span<std::uint8_t> next() { return std::span(row_).subspan(pixel_, stride_); }
    /// Goes on to another row.
    void pass() { above_.swap(row_); }
    /// Appends the filter's number and the filtered row, and goes on to another row.
    void add(PngFilter filter, std::vector<std::uint8_t>& out);

  private:
    void apply(PngFilter filter, std::vector<std::uint8_t>& result) const;
    std::size_t sum(const std::vector<std::uint8_t>& differences) const;

    std::size_t stride_, pixel_;
    std::vector<std::uint8_t> above_, row_;  // after a pixel of zeros, and with room for a block
    std::vector<std::uint8_t> filtered_, tried_;  // with room for a block
};

}  // namespace burl
