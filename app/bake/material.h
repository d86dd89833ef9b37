#pragma once
// The pictures of a bake's material: the base colour with its alpha, and those of the other
// channels, made in one pass.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/export/export.h"
#include "app/pipeline/material.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// Parses --pack; empty means glTF's packing for .glb and .gltf, and one picture per channel
/// otherwise. Throws Error(usage) for another packing than glTF's in a glTF.
Packing packing_asked(const std::string& text, const std::string& out_path);

/// The part of a bake's options that its material depends on.
struct MaterialAsked {
    Packing packing = Packing::gltf;
    int depth = 8;             ///< bits of codes, 8 or 16
    std::uint32_t levels = 0;  ///< number of MIP levels above level 0
    bool normals = false;      ///< whether there is a normal map in tangent space
    double crease_degrees = 40.0;
    bool sharp = false;  ///< whether levels of colours are sharpened (atlas/base/sharp_level.h)

    /// Whether the normal map's levels make the roughness vary.
    bool rough_levels() const { return normals && levels > 0; }
};

/// The names of the pictures that a bake of the recipes, which share an atlas, writes besides the
/// base colour.
std::vector<std::string> picture_names(std::span<const Recipe> recipes, const MaterialAsked& asked);

/// The pictures of a material.
struct BakedMaterial {
    BakedImage color{};  ///< with paint; with alpha if the recipe is transparent
    std::vector<BakedImage> color_levels{};
    std::vector<ExportPicture> pictures{};
    std::vector<Image<RgbF>> normal_levels{};  ///< unit vectors, components -1 to 1
};

/// The material of the pipeline's recipe in codes of 8 or 16 bits. MIP levels are means in linear
/// light, of colours multiplied by their alpha; a mask's alpha keeps its share of the surface, and
/// what normals lose in length becomes roughness (docs/reference/materials-levels.md). Sharp levels
/// are those of colours alone: numbers and normals stay means. Throws
/// Error(usage) for paint over a transparent texture.
///
/// `recipes` are those that share the atlas (app/bake/shared_pictures.h); empty: the pipeline's.
BakedMaterial bake_material(Pipeline& pipeline, const MaterialAsked& asked,
                            std::span<const Recipe> recipes = {});

/// Writes the material in linear floats to `path`, an .exr, with a layer per channel that varies
/// and all MIP levels if any are asked for.
AtomicFile write_material_exr(Pipeline& pipeline, const std::string& path,
                              const MaterialAsked& asked, ExrDepth depth);

/// A sentence on the material's values that are the same everywhere and not the defaults, and that
/// neither the output's file nor its pictures, whose names and packing these are, hold; empty where
/// there are none. An .stl has no material at all, which is told as a loss of its own.
std::string values_not_held(const Recipe& recipe, std::span<const std::string> pictures,
                            Packing packing, const std::string& out_path);

/// Throws Error(usage) in one sentence where a bake cannot give the recipe's material: what the
/// command asks for besides, `what`, is not done for it.
void check_material(const Recipe& recipe, const MaterialAsked& asked, const std::string& what);

}  // namespace burl
