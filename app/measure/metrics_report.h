#pragma once
// The figures of `burl metrics` as JSON and as tables; both come from the same values.
#include <optional>
#include <string>
#include <vector>

#include "app/measure/report.h"
#include "atlas/measure/atlas_measures.h"
#include "atlas/measure/lookup_errors.h"

namespace burl {

/// One atlas that was measured: one of our kinds, or "uv" for the file's own coordinates.
struct MeasuredAtlas {
    std::string name;
    Atlas atlas;
    AtlasMeasures measures;
    std::string texture;  ///< what was looked up
    std::optional<LookupErrors> lookups;
    std::vector<std::string> images;  ///< files drawn
    /// `rmse` of level 1 and up where they are worked out from the recipe
    /// (app/pipeline/direct_levels.h) and not averaged; empty: the texture is no recipe's, or the
    /// atlas not ours.
    std::vector<double> direct{};
};

Json measured_json(const MeasuredAtlas& measured);

/// Prints how the texture is used, how the surface lies in it, and what lookups show of it.
void print_measures(const std::vector<MeasuredAtlas>& atlases);

}  // namespace burl
