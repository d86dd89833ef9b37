#pragma once
// Early exit: octaves are evaluated from the first on, and where whatever the others can add leaves
// the field in an interval in which the colour map is constant, they are left out. Bounds hold for
// every point, so that no byte shows it. Whether that is worth its tests depends on the texture; a
// pilot of some texels decides.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "procedural/batch/texel_batch.h"
#include "procedural/color/constant_intervals.h"

namespace burl {

/// What an octave can add to the field, and what a unit of its kernel's noise adds.
struct OctaveRange {
    double low = 0.0, high = 0.0, unit = 0.0;
};

/// After `octaves` octaves, field values so far that are in one of the intervals have a colour that
/// no further octave changes.
struct ExitPoint {
    std::size_t octaves = 0;
    std::vector<IndexInterval> decided;
};

struct ExitPlan {
    bool repeats = false;           ///< as the map does
    std::size_t octaves = 0;        ///< in all
    std::vector<ExitPoint> points;  ///< where texels are looked at, by rising number of octaves
};

/// Where texels are decided after each number of octaves, 0 to ranges.size() - 1: `intervals` less
/// what is to come. That includes 1e-5 of the octaves' amplitudes and 1e-6: more than sums in
/// float32 of up to 64 octaves, their noise, and the tests' own rounding to float32 err by.
std::vector<ExitPoint> exit_points(const std::vector<IndexInterval>& intervals,
                                   const std::vector<OctaveRange>& ranges);

/// What looks cost, in units of an octave whose kernel works out every corner by itself. Measured;
/// what is wrong here costs time, nothing else.
struct ExitCosts {
    double octave_kept = 0.65;  ///< more than an octave that is not kept
    double test = 0.65;         ///< one look at a texel
};
/// The same for an octave that shares corners among texels, and one without a kernel.
inline constexpr double shared_octave_cost = 0.25, plain_octave_cost = 10.0;

/// The numbers of octaves after which to look, so that most is saved, given the share of texels
/// decided after 0 octaves and more and every octave's cost; none where that saves less than a
/// fifth.
std::vector<std::size_t> cheapest_exits(const std::vector<double>& decided,
                                        const std::vector<double>& octaves,
                                        const ExitCosts& costs = {});

/// The texels of a batch that are not decided, in blocks of batch_padding: whole vectors on every
/// machine. Arrays of the open blocks follow one another in the batch's order.
class OpenBlocks {
  public:
    /// All texels.
    void open(std::size_t count);
    /// Closes blocks without any of the texels `undecided`, which rise and count the open ones.
    /// Calls closed(first open texel, first texel of the batch, their number) for each and returns
    /// the number of their texels.
    template <class Closed>
    std::size_t close(std::span<const std::uint32_t> undecided, const Closed& closed);
    /// Brings an array in order after close(): what was closed is gone.
    template <class T>
    void compact(T* values) const {
        for (std::size_t i = 0; i < kept_.size(); ++i)
            move(values + kept_[i] * batch_padding, values + i * batch_padding);
    }
    /// Of an array of all texels of the batch, the open ones.
    template <class T>
    void gather(T* values) const {
        for (std::size_t i = 0; i < where_.size(); ++i)
            move(values + where_[i] * batch_padding, values + i * batch_padding);
    }
    /// The open texels' values to their places in the batch.
    void scatter(const double* values, double* batch) const;

    bool holds(std::size_t texel) const { return open_[texel / batch_padding]; }
    std::size_t texels() const { return texels_; }

  private:
    template <class T>
    static void move(const T* from, T* to) {
        if (from != to) std::copy_n(from, batch_padding, to);
    }
    std::size_t texels_of(std::size_t block) const {
        return std::min(batch_padding, count_ - block * batch_padding);
    }

    bool open_[batch_capacity / batch_padding] = {};
    std::size_t count_ = 0, texels_ = 0;
    std::vector<std::uint32_t> where_;  ///< the open blocks
    std::vector<std::uint32_t> kept_;   ///< those, by their numbers before the last close()
};

/// What a thread works with: arrays of the open texels.
struct ExitBuffers {
    struct alignas(64) Noise {
        float values[batch_capacity + batch_padding];
    };
    OpenBlocks open;
    alignas(64) double values[batch_capacity + batch_padding] = {};
    alignas(64) double estimate[batch_capacity + batch_padding] = {};
    std::vector<Noise> noise;  ///< of a group's octaves so far
    std::vector<std::uint32_t> positions;
};

template <class Closed>
std::size_t OpenBlocks::close(std::span<const std::uint32_t> undecided, const Closed& closed) {
    const std::size_t before = texels_;
    auto next = undecided.begin();
    std::vector<std::uint32_t> left;
    kept_.clear();
    texels_ = 0;
    for (std::uint32_t i = 0; i < where_.size(); ++i) {
        const std::size_t end = (i + 1) * batch_padding, texels = texels_of(where_[i]);
        const bool decided = next == undecided.end() || *next >= end;
        while (next != undecided.end() && *next < end) ++next;
        if (decided) {
            open_[where_[i]] = false;
            closed(i * batch_padding, where_[i] * batch_padding, texels);
            continue;
        }
        kept_.push_back(i);
        left.push_back(where_[i]);
        texels_ += texels;
    }
    where_.swap(left);
    return before - texels_;
}

}  // namespace burl
