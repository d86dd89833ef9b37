#pragma once
// Which level of a texture to show while a slider moves: the finest one that can be worked out
// within a budget of time, learnt from what levels took (the low-resolution mode of Carr & Hart
// 2001); and the steps back to the finest one once the slider rests.
#include <cstdint>

namespace burl {

class LevelChoice {
  public:
    /// `budget` in seconds; levels 0 to `coarsest`. Until something was measured it is `coarsest`.
    LevelChoice(double budget, std::uint32_t coarsest) : budget_(budget), coarsest_(coarsest) {}

    /// To be shown next while the slider moves.
    std::uint32_t level() const { return level_within(budget_); }
    /// A level took so long; what it says about the others is that each takes a fourth of the next
    /// finer one.
    void took(std::uint32_t level, double seconds);
    /// To be shown after `level`, with nobody waiting for less than `patience` seconds: the finest
    /// that takes no longer, but at least one step finer.
    std::uint32_t finer_than(std::uint32_t level, double patience) const;

  private:
    std::uint32_t level_within(double seconds) const;

    double budget_;
    std::uint32_t coarsest_;
    double finest_seconds_ = -1.0;  ///< what level 0 is taken to need; negative: not known
};

}  // namespace burl
