#pragma once
// Fills an atlas with a texture graph on the host: rows in parallel, texels packed into batches of
// the graph evaluator, all in float64. The bytes do not depend on the thread count.
#include "atlas/image.h"
#include "atlas/solid_atlas.h"
#include "procedural/filter.h"
#include "procedural/graph.h"

namespace burl {

/// `texture_from_atlas` maps the SolidAtlas's space to the texture's solid coordinates (the
/// recipe's scale). With filter `none` texels are point samples, with `supersample` means of such,
/// with any other kind the nodes filter over them (docs/nodes.md). `threads` 0 means all. Texels
/// outside every span get the colour at the origin.
Image<Rgb8> synthesize_graph_rgb8(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& texture_from_atlas, const Filter& filter,
                                  int threads);
Image<Rgb16> synthesize_graph_rgb16(const SolidAtlas& solid, const TextureGraph& graph,
                                    const Affine3& texture_from_atlas, const Filter& filter,
                                    int threads);
Image<RgbF> synthesize_graph_rgbf(const SolidAtlas& solid, const TextureGraph& graph,
                                  const Affine3& texture_from_atlas, const Filter& filter,
                                  int threads);

}  // namespace burl
