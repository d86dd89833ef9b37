#pragma once
// Which parts of the next texture's field are valid in the cache, and which are to be stored there.
#include <cstddef>
#include <vector>

#include "procedural/cache/memory.h"
#include "procedural/field/kept_start.h"
#include "procedural/field/sampler.h"

namespace burl {

/// The caches that the evaluation of one field reads and fills.
struct FieldUse {
    KeptBatch arrays{};              ///< octaves, quadric and prefix of the sum
    double* field = nullptr;         ///< where f is to be stored; null: it is not cached
    bool all_known = false;          ///< whether no noise is evaluated, nor the quadric
    SpanLineCache* lines = nullptr;  ///< null: pieces are made from the texels' maps
};

/// The entries of f in the table of 8-bit colours.
struct EntriesUse {
    std::int32_t* entries = nullptr;  ///< null: the budget has no room for them
    bool known = false;               ///< whether they are valid, or to be stored
};

/// Decides what is valid of one texture's field after another. What is stored between a begin and
/// its end is valid after an end with `complete`, which tells that no texel was left out; what was
/// valid before remains so.
class FieldCache {
  public:
    /// `solid` must outlive this object; the caches take at most `budget` bytes.
    FieldCache(const SolidAtlas& solid, std::size_t budget) : memory_(solid, budget) {}

    const CacheMemory& memory() const { return memory_; }
    /// Invalidates everything, because the map from atlas to texture space changed.
    void invalidate();
    /// Whether f, and its slopes if the filter takes them, are valid.
    bool holds(const FieldKey& key) const { return memory_.field.holds(key); }

    /// Begins the field of `sampler`, whose octaves are cached. An octave, the quadric or f is not
    /// stored while it is dragged; the memory of a dragged f holds the prefix of its sum
    /// (procedural/field/kept_start.h). The arrays may be used until the next begin.
    FieldUse begin(const FieldKey& key, const FieldSampler& sampler);
    void end(const FieldKey& key, const FieldUse& use, bool complete);

    /// Begins a field of which only f and its slopes are cached, in the memory's arrays; false if
    /// the budget has no room for them.
    bool begin_filtered(const FieldKey& key);
    void end_filtered(const FieldKey& key, bool complete);

    /// Records an unfiltered texture that has the field of the one before.
    void repeat() { history_.record_same_field(); }
    /// Begins the colouring of the valid f by its entries in the table of 8-bit colours.
    EntriesUse begin_entries(Wrap wrap);
    void end_entries(Wrap wrap, bool complete);

  private:
    CacheMemory memory_;
    EditTracker history_;
    KeptStart start_;                 ///< prefix of the sum, cached in the memory of f
    std::vector<NoiseKey> keys_;      ///< keys of the octaves of the field begun
    std::vector<KeptNoise> octaves_;  ///< arrays of the octaves of the field begun
};

}  // namespace burl
