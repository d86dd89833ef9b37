#pragma once
// Fills an atlas with a texture graph on the host: rows in parallel, texels packed into batches. In
// float32 point samples go through value programs (graph_values.h); in float64, the reference, and
// where nodes filter, through the graph evaluator with its gradients. The bytes do not depend on
// the thread count.
#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/precision.h"
#include "procedural/batch/row_window.h"
#include "procedural/graph/graph.h"

namespace burl {

/// `texture_from_atlas` maps the SolidAtlas's space to the texture's solid coordinates (the
/// recipe's scale). With filter `none` texels are point samples, with `supersample` means of such,
/// with any other kind the nodes filter over them (docs/reference/nodes.md). `threads` 0 means all.
/// `precision` is float32 or float64. `economy` says what may be left out, which no byte shows, and
/// counts. Texels outside every span get the colour at the origin.
Image<Rgb8> synthesize_graph_rgb8(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& texture_from_atlas, const Filter& filter,
                                  int threads, PrecisionKind precision = PrecisionKind::float32,
                                  const Economy& economy = {});
Image<Rgb16> synthesize_graph_rgb16(const SolidAtlas& solid, const TextureGraph& graph,
                                    const Affine3& texture_from_atlas, const Filter& filter,
                                    int threads, PrecisionKind precision = PrecisionKind::float32,
                                    const Economy& economy = {});
/// Or only some rows of it.
Image<RgbF> synthesize_graph_rgbf(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& texture_from_atlas, const Filter& filter,
                                  int threads, PrecisionKind precision = PrecisionKind::float32,
                                  const Economy& economy = {}, const RowWindow& rows = {});

}  // namespace burl
