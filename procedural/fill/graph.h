#pragma once
// Synthesis of a texture graph on the host: rows in parallel, texels packed into batches. In
// float32 point samples go through value programs (graph/values.h); in float64, the reference, and
// where nodes filter, through the graph evaluator with its gradients. The bytes do not depend on
// the thread count.
#include "atlas/base/image.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/batch/economy.h"
#include "procedural/batch/filter.h"
#include "procedural/batch/precision.h"
#include "procedural/batch/row_window.h"
#include "procedural/fill/mask_images.h"
#include "procedural/graph/graph.h"

namespace burl {

/// The rows `rows` of the texture of a graph as an image of Rgb8, Rgb16 or RgbF.
/// `texture_from_atlas` maps the SolidAtlas's space to the texture's solid coordinates (the
/// recipe's scale). With filter `none` texels are point samples, with `supersample` means of point
/// samples, with any other kind the nodes filter over them (docs/reference/nodes.md). `threads` 0
/// means all. `precision` is float32 or float64. `economy` decides which work is left out, which
/// changes no byte, and counts work. `masks` has an image for each mask that the colour reads, else
/// Error(unsupported) is thrown. Texels outside every span get the colour at the origin, with masks
/// of 0.
template <class Pixel>
Image<Pixel> synthesize_graph(const SolidAtlas& solid, const TextureGraph& graph,
                              const Affine3& texture_from_atlas, const Filter& filter, int threads,
                              PrecisionKind precision = PrecisionKind::float32,
                              const Economy& economy = {}, const RowWindow& rows = {},
                              const MaskImages& masks = {});

}  // namespace burl
