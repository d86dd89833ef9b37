#pragma once
// The pictures that a material needs: which channels vary, and how they are packed for the programs
// that read them. Whatever does not vary is a number of the material, or, for programs that read
// pictures alone, a component with one value.
#include <string>
#include <vector>

#include "app/recipe/recipe.h"
#include "atlas/base/enum_names.h"
#include "procedural/fill/pictures.h"

namespace burl {

/// Who reads the pictures, and so which channel is in which component.
enum class Packing {
    gltf,     ///< glTF 2.0: occlusion, roughness, metallic; only what varies
    unreal,   ///< Unreal Engine: the same order, always
    unity,    ///< Unity's mask map: metallic, occlusion, none, smoothness
    godot,    ///< Godot's ORM material: as Unreal's
    separate  ///< one picture per channel
};
template <>
inline constexpr auto enum_names<Packing> = enum_words("gltf", "unreal", "unity", "godot",
                                                       "separate");

/// A picture of a material besides its base colour.
struct MaterialPicture {
    std::string name;  ///< "orm", "emissive", ...: the end of its file's name
    PicturePlan plan{};
    std::size_t components = 3;  ///< how many of the plan's components it has, 1, 3 or 4
    /// Places in a glTF material that refer to it, as JSON pointers.
    std::vector<std::string> slots{};
    /// The component that holds the roughness, or one less it.
    std::optional<std::size_t> roughness{};
};

/// The number of a channel that is no colour and does not vary.
double channel_number(const Material& material, Channel channel);

/// Whether the recipe's base colour may be transparent, and is to stay so.
bool is_transparent(const Recipe& recipe);

/// Whether the recipe has more than an opaque base colour.
bool has_pictures(const Recipe& recipe, Packing packing, bool rough_levels = false);

/// The material's numbers as factors of its pictures: 1 and white for channels that have one.
Material material_factors(const Recipe& recipe, bool rough_levels = false);

/// The plan of the base colour, with alpha times opacity.
PicturePlan base_color_plan(const Recipe& recipe);

/// Unit vectors in the codes of a normal map (procedural/fill/tangent_frame.h).
Image<Rgb8> normal_codes8(const Image<RgbF>& normals);
Image<Rgb16> normal_codes16(const Image<RgbF>& normals);

/// The pictures besides the base colour and the normal map. `rough_levels`: the roughness has one
/// even where it does not vary, since the MIP levels of a normal map make it vary.
std::vector<MaterialPicture> material_pictures(const Recipe& recipe, Packing packing,
                                               bool rough_levels = false);

}  // namespace burl
