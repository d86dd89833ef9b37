#pragma once
// The pictures of a recipe in the order in which a program that edits it shows them: at once one
// that answers the slider, then finer ones until the texture itself is there or somebody stops it
// because the recipe has changed.
#include <chrono>
#include <stop_token>

#include "app/pipeline/level_choice.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// Whether the slider is still being dragged: then one picture is all.
enum class Drag { moving, released };

/// Calls show(level, picture) for one picture of the pipeline's recipe after another, and tells
/// `choice` what each took. Meant for a thread of its own, which shows what it has and, with a new
/// recipe, is stopped and called again. Returns whether nobody stopped it. `patience` in seconds as
/// in LevelChoice::finer_than.
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
