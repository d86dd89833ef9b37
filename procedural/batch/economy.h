#pragma once
// Work that a texture can do without: what may be left out, each kind by a name so that tests and
// measurements can forbid it, and counts of what was done and what was spared. No result depends on
// it (docs/lab/economy.md says where a bound stands for equality).
#include <array>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <string_view>

namespace burl {

/// Work that is left out where nobody would see its result.
enum class Skip : unsigned {
    stages,          ///< stages of the pipeline whose inputs did not change
    zero_terms,      ///< octaves without amplitude, quadric coefficients of zero
    constants,       ///< parts of a graph that do not depend on the point
    subtrees,        ///< parts of a graph that occur again
    band_limit,      ///< octaves that a texel cannot show
    early_exit,      ///< octaves that cannot leave an interval of one colour any more
    constant_tiles,  ///< runs of texels that all have one colour, by interval arithmetic
    unread_texels,   ///< texels that no lookup reads
    covered_layers,  ///< layers under an opaque one
    kept_terms,      ///< octaves and fields that an edit leaves as they are
    unseen_tiles,    ///< tiles and levels that a view does not show
    up_to_date,      ///< outputs whose inputs did not change
};

inline constexpr std::array<std::string_view, 12> skip_names = {
    "stages",         "zero-terms", "constants",      "subtrees",
    "band-limit",     "early-exit", "constant-tiles", "unread-texels",
    "covered-layers", "kept-terms", "unseen-tiles",   "up-to-date"};

/// Which kinds are allowed; all, to begin with.
class Skips {
  public:
    bool allows(Skip skip) const { return (forbidden_ >> unsigned(skip) & 1U) == 0; }
    void forbid(Skip skip) { forbidden_ |= 1U << unsigned(skip); }
    bool operator==(const Skips&) const = default;

  private:
    std::uint32_t forbidden_ = 0;
};

/// What syntheses did and what they left out, by the reason; skipped[k] is Skip(k)'s.
struct SynthesisWork {
    std::uint64_t texels = 0;   ///< whose colour was worked out
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

/// What a synthesis may leave out, and where it adds what it did; null: nowhere. Once `stop` is
/// asked for, which another thread may do, it returns soon, and its result is worth nothing.
struct Economy {
    Skips skips{};
    SynthesisWork* work = nullptr;
    std::stop_token stop{};
};

}  // namespace burl
