#pragma once
// Work that a texture can do without: every kind has a name, by which tests and measurements forbid
// leaving it out, and counts of what was done and what was skipped. Skipping changes no byte of a
// result, except for the band limit, which a recipe asks for (docs/lab/economy.md).
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <string_view>

#include "atlas/base/task_meter.h"

namespace burl {

/// Kinds of work that are left out because the result does not need them.
enum class Skip : unsigned {
    stages,         ///< pipeline stages whose inputs did not change
    zero_terms,     ///< octaves of amplitude 0 and quadric coefficients of 0
    constants,      ///< parts of a graph that do not depend on the point: evaluated once
    subtrees,       ///< common subexpressions of a graph: evaluated once
    band_limit,     ///< octaves too fine for a texel to show
    unread_texels,  ///< texels that no lookup reads
    kept_terms,     ///< octaves and fields that an edit leaves unchanged
    unseen_tiles,   ///< tiles and MIP levels that a view does not show
    up_to_date,     ///< output files whose inputs did not change
};

inline constexpr std::array<std::string_view, 9> skip_names = {
    "stages",        "zero-terms", "constants",    "subtrees",  "band-limit",
    "unread-texels", "kept-terms", "unseen-tiles", "up-to-date"};

/// The set of kinds of work that may be left out: all of them until one is forbidden.
class Skips {
  public:
    bool allows(Skip skip) const { return (forbidden_ >> unsigned(skip) & 1U) == 0; }
    void forbid(Skip skip) { forbidden_ |= 1U << unsigned(skip); }
    bool operator==(const Skips&) const = default;

  private:
    std::uint32_t forbidden_ = 0;
};

/// Counts of the work that syntheses did and left out; element k of an array counts the work left
/// out for the reason Skip(k).
struct SynthesisWork {
    std::uint64_t texels = 0;   ///< texels whose colour was computed
    std::uint64_t octaves = 0;  ///< octaves evaluated, one per texel and octave
    std::array<std::uint64_t, skip_names.size()> texels_skipped{};
    std::array<std::uint64_t, skip_names.size()> octaves_skipped{};

    void skip_texels(Skip why, std::uint64_t count) { texels_skipped[unsigned(why)] += count; }
    void skip_octaves(Skip why, std::uint64_t count) { octaves_skipped[unsigned(why)] += count; }
    SynthesisWork& operator+=(const SynthesisWork& more) {
        texels += more.texels;
        octaves += more.octaves;
        for (std::size_t k = 0; k < skip_names.size(); ++k) {
            texels_skipped[k] += more.texels_skipped[k];
            octaves_skipped[k] += more.octaves_skipped[k];
        }
        return *this;
    }
    bool operator==(const SynthesisWork&) const = default;
};

/// The sum of SynthesisWork over threads: whole numbers, whose sum does not depend on the order.
class WorkSum {
  public:
    /// The sum is added to `total`, which may be null.
    explicit WorkSum(SynthesisWork* total) : total_(total) {}

    void add(const SynthesisWork& work) {
        if (!total_) return;
        const std::lock_guard lock(mutex_);
        *total_ += work;
    }

  private:
    std::mutex mutex_;
    SynthesisWork* total_;
};

/// The work that a synthesis may leave out, the counts that it adds to (`work`; null: none), a
/// request to stop, and a meter that gets texels as they are done (null: none). Once another thread
/// requests a stop, the synthesis returns soon and its result must not be used.
struct Economy {
    Skips skips{};
    SynthesisWork* work = nullptr;
    std::stop_token stop{};
    TaskMeter* meter = nullptr;

    /// Tells the meter of rows of so many texels, without those that show nothing.
    void count(std::size_t rows, std::size_t texels) const {
        if (meter) meter->add(std::uint64_t(rows) * texels);
    }
};

}  // namespace burl
