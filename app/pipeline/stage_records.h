#pragma once
// Records of a pipeline's stages: times, and machine-independent counts of work done and left out.
// A cached result that is still valid for a new recipe counts as kept, with the cost of making it,
// when that recipe first needs it.
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "app/base/stopwatch.h"
#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"

namespace burl {

/// Stages in the order of their dependencies.
enum class Stage : unsigned {
    connectivity,
    layout,
    spans,
    masks,
    synthesis,
    paint,
    levels,
    normals
};

inline constexpr std::array<std::string_view, 8> stage_names = {
    "connectivity", "layout", "spans", "masks", "synthesis", "paint", "levels", "normals"};

/// Cost of one run of a stage.
struct StageCost {
    std::uint64_t triangles = 0;  ///< triangles processed
    std::uint64_t bytes = 0;      ///< size of the result
    /// Texels and octaves evaluated, and those left out by reason.
    SynthesisWork work{};
};

/// The number of texels in spans.
std::uint64_t texels_of(const SolidAtlas& solid);

template <class Element>
std::uint64_t bytes_of(const std::vector<Element>& elements) {
    return elements.size() * sizeof(Element);
}

template <class Pixel>
std::uint64_t bytes_of(const Image<Pixel>& image) {
    return image.width() * image.height() * sizeof(Pixel);
}

/// Record of one stage over all recipes.
struct StageRecord {
    std::uint64_t runs = 0;     ///< number of runs that came to their end
    std::uint64_t kept = 0;     ///< number of recipes that used a cached result
    std::uint64_t stopped = 0;  ///< number of runs that were stopped
    double seconds = 0.0;       ///< time of all runs, stopped ones included
    StageCost done{};           ///< cost of all finished runs
    StageCost last{};           ///< cost of the latest finished run
    StageCost spared{};         ///< cost of the runs that cached results spared (Skip::stages)
};

/// Records of all stages. Not to be used by two threads at a time.
class StageRecords {
  public:
    const StageRecord& operator[](Stage stage) const { return records_[unsigned(stage)]; }

    /// Begins a recipe: each stage's cached result may count as kept once.
    void begin_recipe() { unasked_.fill(true); }
    /// Counts a cached result of the stage as kept; false if the recipe has used the stage before.
    bool keep(Stage stage);
    /// Adds a run of the stage that came to its end.
    void add(Stage stage, double seconds, const StageCost& cost);

    /// Calls run(cost), which sets the cost and returns the stage's result, and adds the run with
    /// its time.
    template <class Run>
    auto time(Stage stage, const Run& run) {
        StageCost cost;
        const auto start = std::chrono::steady_clock::now();
        auto result = run(cost);
        add(stage, seconds_since(start), cost);
        return result;
    }
    /// Calls run(cost), which sets the cost and returns whether the stage came to its end, and adds
    /// the run or counts it as stopped.
    template <class Run>
    bool attempt(Stage stage, const Run& run) {
        StageCost cost;
        const auto start = std::chrono::steady_clock::now();
        const bool done = run(cost);
        if (done)
            add(stage, seconds_since(start), cost);
        else
            stop(stage, seconds_since(start));
        return done;
    }

  private:
    void stop(Stage stage, double seconds);

    std::array<StageRecord, stage_names.size()> records_{};
    std::array<bool, stage_names.size()> unasked_{};
};

}  // namespace burl
