#pragma once
// Numbers distinct rows of words in the order of their first occurrence: exporters share vertices
// that agree in every bit. A hash table with open addressing and linear probing; std::unordered_map
// costs several times as much here.
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace burl {

template <std::size_t Words>
class UniqueRows {
  public:
    using Row = std::array<std::uint32_t, Words>;

    explicit UniqueRows(std::size_t expected) : slots_(std::bit_ceil(2 * expected + 2), empty) {}

    /// The row's number, from 0; a new row gets the next one.
    std::uint32_t insert(const Row& row) {
        if (2 * rows_.size() >= slots_.size()) grow();
        std::uint32_t& slot = slots_[find(row)];
        if (slot == empty) {
            slot = std::uint32_t(rows_.size());
            rows_.push_back(row);
        }
        return slot;
    }

    const std::vector<Row>& rows() const { return rows_; }
    /// Moves out the rows, indexed by number, and drops the hash table.
    std::vector<Row> take_rows() && {
        slots_ = {};
        return std::move(rows_);
    }

  private:
    static constexpr std::uint32_t empty = 0xffffffffu;

    std::size_t find(const Row& row) const {
        std::uint64_t hash = 0;
        for (const std::uint32_t word : row) {
            hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
            hash ^= hash >> 32;
        }
        std::size_t at = hash & (slots_.size() - 1);
        while (slots_[at] != empty && rows_[slots_[at]] != row) at = (at + 1) & (slots_.size() - 1);
        return at;
    }

    void grow() {
        slots_.assign(2 * slots_.size(), empty);
        for (std::uint32_t i = 0; i < rows_.size(); ++i) slots_[find(rows_[i])] = i;
    }

    std::vector<std::uint32_t> slots_;
    std::vector<Row> rows_;
};

}  // namespace burl
