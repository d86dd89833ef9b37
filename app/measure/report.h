#pragma once
// The results of verbs as JSON for pipelines.
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/pipeline/pipeline.h"
#include "atlas/build/capacity.h"
#include "atlas/measure/atlas_measures.h"

namespace burl {

using Json = nlohmann::ordered_json;

/// Counts of the mesh, and the reader's notes.
Json mesh_json(const Mesh& mesh, const Connectivity& connectivity);

/// Coverage, relative scale, density percentiles and the layout's own counts.
Json metrics_json(const Atlas& atlas, const AtlasMetrics& metrics);

/// Texels per triangle and the sizes that would suffice; a size that no texture has is 0.
Json capacity_json(const Capacity& capacity);

/// Counts of the parametrisation and layout of a patch atlas.
Json patches_json(const PatchAtlas& atlas);

/// Per stage that ran, the seconds of all its runs.
Json times_json(const StageRecords& records);

/// Per stage, the work done and the work skipped, by reason (procedural/batch/economy.h).
Json stages_json(const StageRecords& records);

/// The version, library versions and SIMD level.
Json versions_json();

/// Writes `json` to a file, or to stdout when `path` is "-". Throws Error(io).
void write_json(const std::string& path, const Json& json);

}  // namespace burl
