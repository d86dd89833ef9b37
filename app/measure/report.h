#pragma once
// What a verb found out, as JSON for pipelines and as short lines for people; both come from the
// same values.
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/pipeline/pipeline.h"
#include "atlas/build/capacity.h"
#include "atlas/measure/metrics.h"

namespace burl {

using Json = nlohmann::ordered_json;

/// Counts of the mesh and of what reading noticed.
Json mesh_json(const Mesh& mesh, const Connectivity& connectivity);

/// Coverage, relative scale, density percentiles (DESIGN names) and the layout's own counts.
Json metrics_json(const Atlas& atlas, const AtlasMetrics& metrics);

/// Texels per triangle and what sizes would do; sizes that no texture has are 0.
Json capacity_json(const Capacity& capacity);

/// What mapping and placing a patch atlas did.
Json patches_json(const PatchAtlas& atlas);

/// Seconds per stage that ran, of all its runs.
Json times_json(const StageRecords& records);

/// What every stage did and what it could leave out, by the reason (procedural/batch/economy.h).
Json stages_json(const StageRecords& records);

/// Version, library versions and SIMD level.
Json versions_json();

/// Writes `json` to a file, or to stdout when `path` is "-". Throws Error(io).
void write_json(const std::string& path, const Json& json);

}  // namespace burl
