#pragma once
// How far long work is, told by callbacks.
#include <functional>
#include <optional>
#include <string>

namespace burl::library {

/// How far work is.
struct ProgressState {
    /// The stage that runs, such as "synthesising the texture"; "done" at the end.
    std::string stage{};
    /// The share of the work that is done, 0 to 1, never less than before; an estimate, and 0 where
    /// there is none.
    double share = 0.0;
    /// Texels a second of the stage; none where it counts no texels.
    std::optional<double> texels_per_second{};
    /// Seconds that the rest may take; none where it is not known.
    std::optional<double> seconds_left{};
};

/// Is called by the thread that called the function, when a stage begins and every 50 ms. Returning
/// false stops the work, and so does an exception, which the function lets through.
using Progress = std::function<bool(const ProgressState& state)>;

}  // namespace burl::library
