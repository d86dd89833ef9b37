#pragma once
// Patch atlases are better than quad atlases and take about ten times as long to lay out: an editor
// shows a large mesh with a quad atlas first and lays out the patches meanwhile.
#include <optional>
#include <stop_token>

#include "app/pipeline/pipeline.h"

namespace burl {

/// The number of triangles above which patches are laid out in the background: patches of so many
/// triangles take about a second on two cores.
inline constexpr std::size_t many_faces = 40000;

/// Returns the atlas to show a mesh with at once: `wanted`, or, where patches of more than
/// `many_faces` triangles are wanted, a quad atlas of the largest power of two not above the wanted
/// size.
AtlasOptions atlas_at_once(const AtlasOptions& wanted, std::size_t triangles);

/// Lays out the atlas of the pipeline's recipe and makes its texels' solid points, at low priority
/// on all cores but one (on the only one, where there is one). Returns false where `stop` was
/// requested first.
bool lay_out_aside(Pipeline& pipeline, const std::stop_token& stop);

}  // namespace burl
