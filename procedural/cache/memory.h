#pragma once
// The memory of a field's caches: arrays of numbers per texel within a budget, each with the key of
// what it holds.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "procedural/cache/edit_tracker.h"
#include "procedural/cache/span_line_cache.h"
#include "procedural/cache/texel_layout.h"
#include "procedural/color/map.h"

namespace burl {

/// Array of numbers per texel, and the key of what they are. Without an array nothing is valid.
template <class T, class Key>
class KeyedArray {
  public:
    T* data() const { return array_.data(); }
    std::size_t bytes_per_texel() const { return data() ? sizeof(T) : 0; }
    const std::optional<Key>& key() const { return key_; }
    /// Whether the numbers are those of `key`.
    bool holds(const Key& key) const { return data() && key_ == key; }
    void set_key(const Key& key) { key_ = key; }
    void invalidate() { key_.reset(); }
    /// Allots `count` numbers, which are not valid, unless there is an array.
    void allot(std::size_t count) {
        if (data()) return;
        array_ = CacheArray<T>(count);
        invalidate();
    }
    void free() { *this = {}; }

  private:
    CacheArray<T> array_;
    std::optional<Key> key_;
};

/// The caches of one atlas's field, all empty at first. Its functions give and take memory, in
/// order of priority: f, octaves, quadric, span lines, entries of the colour table. A freed array
/// is taken over by what needs one.
class CacheMemory {
  public:
    /// `solid` must outlive this object; its arrays take at most `budget` bytes.
    CacheMemory(const SolidAtlas& solid, std::size_t budget)
        : layout(solid), lines(solid), budget_(budget) {}

    /// Allots the arrays of f, and of its slopes if `slopes`, else frees the slopes'. Frees all of
    /// them and gives false if the budget has no room.
    bool allot_field(bool slopes);
    /// Allots the arrays of f without slopes, of octaves and of the quadric, as many as fit, and
    /// frees those of all other octaves. A valid octave keeps its array; dragged ones get none.
    void allot_octaves(const std::vector<NoiseKey>& keys, const EditTracker& history);
    /// Allots the span lines if the last allot_octaves() left room for them.
    void allot_lines();
    /// Allots the entries of the colour table; false if the budget has no room for them.
    bool allot_entries();
    /// Frees all but f and its slopes.
    void free_octaves();
    /// Marks everything as invalid; the memory stays.
    void invalidate();
    /// The size of all arrays in bytes.
    std::size_t bytes() const;

    const TexelLayout layout;
    KeyedArray<double, FieldKey> field;
    CacheArray<float> slopes_u, slopes_v;  ///< df/du and df/dv, valid if `field` is
    std::vector<KeyedArray<float, NoiseKey>> octaves;
    KeyedArray<double, Quadric> quadric;
    SpanLineCache lines;
    KeyedArray<std::int32_t, Wrap> entries;  ///< entries of f in the table of 8-bit colours

  private:
    std::size_t bytes_per_texel() const { return layout.size() > 0 ? budget_ / layout.size() : 0; }

    std::size_t budget_;
    bool lines_fit_ = false;
};

}  // namespace burl
