#pragma once
// The figures of `burl metrics` as JSON and as tables, from the same values.
#include <optional>
#include <string>
#include <vector>

#include "app/measure/report.h"
#include "atlas/measure/atlas_measures.h"
#include "atlas/measure/lookup_errors.h"

namespace burl {

/// An atlas that was measured: one of Burl's kinds, or "uv" for the file's own coordinates.
struct MeasuredAtlas {
    std::string name;
    Atlas atlas;
    AtlasMeasures measures;
    std::string texture;  ///< the name of the texture that was looked up
    std::optional<LookupErrors> lookups;
    std::vector<std::string> images;  ///< the files drawn
    /// `rmse` of levels 1 and up where they are evaluated from the recipe
    /// (app/pipeline/direct_levels.h) rather than averaged; empty where the texture is not a
    /// recipe's or the atlas not one of Burl's.
    std::vector<double> direct{};
};

/// The rows of sampled views as an array of objects.
Json views_json(const std::vector<ViewError>& views);

Json measured_json(const MeasuredAtlas& measured);

/// Prints tables of the texture's use, the surface's shape in it, and the errors of lookups.
void print_measures(const std::vector<MeasuredAtlas>& atlases);

}  // namespace burl
