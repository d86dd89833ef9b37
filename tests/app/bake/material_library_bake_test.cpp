// Every material of the library in a baked .glb: what its pictures hold against the graphs of its
// channels at the texels' points.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "app/bake/bake.h"
#include "app/recipe/channel_texture.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/presets.h"
#include "app/surface/sample_meshes.h"
#include "procedural/graph/evaluator.h"
#include "tests/app/support/glb_pictures.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

/// A place in a glTF material, the component and channel of the picture that it names, and the
/// place of the picture's factor; colours have the factor 1.
struct Slot {
    const char* place;
    std::size_t component;
    const char* channel;
    const char* factor = "/none";
};

constexpr Slot slots[]{
    {"/pbrMetallicRoughness/baseColorTexture", 0, "base_color"},
    {"/pbrMetallicRoughness/metallicRoughnessTexture", 1, "roughness",
     "/pbrMetallicRoughness/roughnessFactor"},
    {"/pbrMetallicRoughness/metallicRoughnessTexture", 2, "metallic",
     "/pbrMetallicRoughness/metallicFactor"},
    {"/occlusionTexture", 0, "occlusion"},
    {"/emissiveTexture", 0, "emissive"},
    {"/extensions/KHR_materials_specular/specularTexture", 3, "specular",
     "/extensions/KHR_materials_specular/specularFactor"},
    {"/extensions/KHR_materials_clearcoat/clearcoatTexture", 0, "clearcoat",
     "/extensions/KHR_materials_clearcoat/clearcoatFactor"},
    {"/extensions/KHR_materials_clearcoat/clearcoatRoughnessTexture", 1, "clearcoat_roughness",
     "/extensions/KHR_materials_clearcoat/clearcoatRoughnessFactor"},
    {"/extensions/KHR_materials_sheen/sheenColorTexture", 0, "sheen"},
    {"/extensions/KHR_materials_sheen/sheenRoughnessTexture", 3, "sheen_roughness",
     "/extensions/KHR_materials_sheen/sheenRoughnessFactor"},
    {"/extensions/KHR_materials_transmission/transmissionTexture", 0, "transmission",
     "/extensions/KHR_materials_transmission/transmissionFactor"}};

/// The code, from 0 to 255 and not rounded, of component `c` of a colour not multiplied by alpha.
double color_code(const GraphSample& sample, std::size_t c) {
    if (sample.wire == Wire::number) c = 0;
    const double alpha = sample.wire == Wire::color ? sample.channels[3].value : 1.0;
    const double x = std::clamp(sample.channels[c].value / (alpha > 0.0 ? alpha : 1.0), 0.0, 1.0);
    return 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

class LibraryBake : public testing::Test {
  protected:
    void bake_to_glb(const Recipe& recipe) {
        pipeline_.set_recipe(recipe);
        BakePlan plan;
        plan.paths = {folder_ / "a.glb"};
        plan.recipe = [&](std::size_t) { return recipe; };
        plan.measures = false;
        bake(pipeline_, plan);
    }

    /// The largest difference in codes of a slot's picture, times its factor, from its channel,
    /// over all texels that a triangle owns.
    double largest_difference(const RawPng& picture, const Slot& slot, double factor) {
        const Recipe& recipe = pipeline_.recipe();
        const std::size_t components = picture.codes.size() / picture.width / picture.height;
        const bool color = std::string_view(slot.place).find("olorTexture") != std::string::npos ||
                           std::string_view(slot.channel) == "emissive";
        const GraphEvaluator evaluate(channel_texture(recipe, slot.channel));
        const Affine3 map = texture_from_solid(recipe);
        double worst = 0.0;
        const auto compare = [&](std::size_t at, const GraphSample& sample) {
            if (sample.wire == Wire::color && sample.channels[3].value < 1 / 255.0) return;
            for (std::size_t c = 0; c < (color ? 3 : 1); ++c) {
                const double code = color ? color_code(sample, c)
                                          : 255.0 * std::clamp(sample.channels[0].value, 0.0, 1.0);
                worst = std::max(worst,
                                 std::abs(factor * picture.codes[at + slot.component + c] - code));
            }
        };
        for (std::size_t y = 0; y < picture.height; ++y)
            for (const Span& span : pipeline_.solid().row(y))
                for (std::uint32_t i = 0; i < span.count; ++i) {
                    const Vec3d point =
                        pipeline_.solid().maps[span.map](span.x + i, std::int64_t(y));
                    compare((y * picture.width + span.x + i) * components, evaluate(map(point)));
                }
        return worst;
    }

    ScratchFolder folder_;
    Pipeline pipeline_{sample_mesh("sample:cube")};
};

TEST_F(LibraryBake, EveryChannelIsItsGraphToOneCode) {
    std::size_t pictures = 0;
    for (const std::string_view name : material_names()) {
        Recipe recipe = load_recipe(std::string(name), {});
        recipe.atlas.size = 24;
        recipe.precision.kind = PrecisionKind::float64;
        bake_to_glb(recipe);
        const Glb glb(folder_ / "a.glb");
        for (const Slot& slot : slots) {
            const Json::json_pointer place(slot.place);
            const Json& material = glb.document["materials"][0];
            if (!material.contains(place)) continue;
            const double factor = material.value(Json::json_pointer(slot.factor), 1.0);
            EXPECT_LE(largest_difference(glb.texture(material[place]), slot, factor), 1.0)
                << name << " " << slot.channel;
            ++pictures;
        }
    }
    EXPECT_GT(pictures, 2 * material_names().size());
}

}  // namespace
}  // namespace burl
