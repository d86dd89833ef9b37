#pragma once
// Progressive refinement of a recipe's picture in an editor: first a level that answers the slider
// in time, then finer levels up to the texture itself, until a stop is requested because the recipe
// has changed. The level is chosen from the latest measurement (the low-resolution mode of Carr &
// Hart 2001).
#include <chrono>
#include <cstdint>
#include <stop_token>

#include "app/pipeline/pipeline.h"

namespace burl {

/// LOD choice by measured times: the finest MIP level that fits into a budget of time while a
/// slider moves, and the steps back to the finest level once it rests.
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

/// State of the slider: while it is dragged (`moving`), refine() shows one picture.
enum class SliderState { moving, released };

/// Calls make(level), which returns what it made or nothing (a pointer or an optional), and
/// show(level, what was made) for one level after another, and tells `choice` how long the making
/// took. Meant for a worker thread, which is stopped and started again when the recipe changes.
/// Returns false where nothing was made. `patience` is in seconds (LevelChoice::finer_than).
template <class Make, class Show>
bool refine_made(LevelChoice& choice, SliderState slider, double patience, const Make& make,
                 const Show& show) {
    for (std::uint32_t level = choice.level();; level = choice.finer_than(level, patience)) {
        const auto start = std::chrono::steady_clock::now();
        const auto made = make(level);
        if (!made) return false;
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        choice.took(level, took.count());
        show(level, *made);
        if (level == 0 || slider == SliderState::moving) return true;
    }
}

/// Calls show(level, picture) for one level of the pipeline's recipe after another, as
/// refine_made() does. Returns false if `stop` was requested.
template <class Pixel, class Show>
bool refine(Pipeline& pipeline, LevelChoice& choice, SliderState slider, double patience,
            const std::stop_token& stop, const Show& show) {
    const auto make = [&](std::uint32_t level) { return pipeline.picture<Pixel>(level, stop); };
    return refine_made(choice, slider, patience, make, show);
}

}  // namespace burl
