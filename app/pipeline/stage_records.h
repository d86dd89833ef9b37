#pragma once
// What the stages of a pipeline did and what they could leave out: times, and counts that do not
// depend on the machine. A result that is still valid for a new recipe counts as kept, with what
// making it took, once that recipe asks for it.
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "app/base/stopwatch.h"
#include "procedural/batch/economy.h"

namespace burl {

/// In the order in which they need one another.
enum class Stage : unsigned { connectivity, layout, spans, synthesis, paint, levels, normals };

inline constexpr std::array<std::string_view, 7> stage_names = {
    "connectivity", "layout", "spans", "synthesis", "paint", "levels", "normals"};

/// What one run of a stage took.
struct StageCost {
    std::uint64_t triangles = 0;  ///< that it went through
    std::uint64_t bytes = 0;      ///< of its result
    /// Texels and octave evaluations, and those it did not need by the reason.
    SynthesisWork work{};
};

struct StageRecord {
    std::uint64_t runs = 0;     ///< how often it was done
    std::uint64_t kept = 0;     ///< for how many recipes an earlier result did
    std::uint64_t stopped = 0;  ///< how often somebody did not wait for its end
    double seconds = 0.0;       ///< of all runs
    StageCost done{};           ///< by all runs
    StageCost last{};           ///< by the latest run
    StageCost spared{};         ///< what the latest runs took whose results did (Skip::stages)
};

class StageRecords {
  public:
    const StageRecord& operator[](Stage stage) const { return records_[unsigned(stage)]; }

    /// A recipe was set: results that it leaves valid have not been asked for since.
    void begin_recipe() { unasked_.fill(true); }
    /// An earlier result of the stage is what the recipe needs; whether that is news.
    bool keep(Stage stage);
    /// The stage ran to its end.
    void add(Stage stage, double seconds, const StageCost& cost);

    /// Runs stage(cost), which gives its result and says what it took, and adds that.
    template <class Run>
    auto time(Stage stage, const Run& run) {
        StageCost cost;
        const auto start = std::chrono::steady_clock::now();
        auto result = run(cost);
        add(stage, seconds_since(start), cost);
        return result;
    }
    /// The same where stage(cost) says whether it came to its end.
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
