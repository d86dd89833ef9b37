#pragma once
// Masks of the mesh's shape as pictures of their own, without a recipe's graph.
#include <span>
#include <string>
#include <string_view>

#include "app/pipeline/pipeline.h"

namespace burl {

/// The one mask that is a colour, and so has light_picture() instead of mask_picture().
inline constexpr std::string_view light_picture_name = "lighting";

/// The masks that have pictures, by the names of their nodes: those that are numbers, and lighting.
std::span<const std::string_view> mask_picture_names();

/// The mask of that name over the pipeline's atlas, with the node's defaults and in the recipe's
/// units, as linear codes. What lies from -1 to 1 is taken to [0, 1], and lengths are shares of the
/// diagonal of the mesh's box. Defined for Grey8 and Grey16.
template <class Code>
Image<Code> mask_picture(Pipeline& pipeline, const std::string& name);

/// The light over the pipeline's atlas that the node `lighting` gives with its defaults, as sRGB
/// codes; more light than 1 is cut to 1. Defined for Rgb8 and Rgb16.
template <class Pixel>
Image<Pixel> light_picture(Pipeline& pipeline);

}  // namespace burl
