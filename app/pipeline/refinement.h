#pragma once
// Progressive refinement of a recipe's picture in an editor: first a level that answers the slider
// in time, then finer levels up to the texture itself, until a stop is requested because the recipe
// has changed.
#include <chrono>
#include <stop_token>

#include "app/pipeline/level_choice.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// State of the slider: while it is dragged (`moving`), refine() shows one picture.
enum class Drag { moving, released };

/// Calls show(level, picture) for one level of the pipeline's recipe after another, and tells
/// `choice` how long each took. Meant for a worker thread, which is stopped and started again when
/// the recipe changes. Returns false if `stop` was requested. `patience` is in seconds
/// (LevelChoice::finer_than).
template <class Pixel, class Show>
bool refine(Pipeline& pipeline, LevelChoice& choice, Drag drag, double patience,
            const std::stop_token& stop, const Show& show) {
    for (std::uint32_t level = choice.level();; level = choice.finer_than(level, patience)) {
        const auto start = std::chrono::steady_clock::now();
        const Image<Pixel>* picture = pipeline.picture<Pixel>(level, stop);
        if (!picture) return false;
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        choice.took(level, took.count());
        show(level, *picture);
        if (level == 0 || drag == Drag::moving) return true;
    }
}

}  // namespace burl
