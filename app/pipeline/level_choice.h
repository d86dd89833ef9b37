#pragma once
// LOD choice while a slider moves: the finest MIP level that can be synthesised within a budget of
// time, estimated from the latest measurement (the low-resolution mode of Carr & Hart 2001), and
// the steps back to the finest level once the slider rests.
#include <cstdint>

namespace burl {

/// Choice of the level to show next, by measured times.
class LevelChoice {
  public:
    /// Chooses among the levels 0 to `coarsest`; `budget` is in seconds. Until took() was called
    /// the choice is `coarsest`.
    LevelChoice(double budget, std::uint32_t coarsest) : budget_(budget), coarsest_(coarsest) {}

    /// The level to show next while the slider moves.
    std::uint32_t level() const { return level_within(budget_); }
    /// Notes that synthesis of `level` took `seconds`. Every level is taken to need a quarter of
    /// the next finer one's time.
    void took(std::uint32_t level, double seconds);
    /// The level to show after `level` once the slider rests: the finest that takes at most
    /// `patience` seconds, but at least one level finer than `level`; 0 after 0.
    std::uint32_t finer_than(std::uint32_t level, double patience) const;

  private:
    /// The finest level that is estimated to take at most `seconds`; if none does, `coarsest`.
    std::uint32_t level_within(double seconds) const;

    double budget_;
    std::uint32_t coarsest_;
    double finest_seconds_ = -1.0;  ///< estimated time of level 0; negative: not known
};

}  // namespace burl
