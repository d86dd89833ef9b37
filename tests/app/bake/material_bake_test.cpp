// Materials in the files that a bake writes, every channel against its own graph at the texels'
// points.
#include <cmath>

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/bake/bake.h"
#include "app/base/file_bytes.h"
#include "app/recipe/channel_texture.h"
#include "app/recipe/edit/images.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "procedural/graph/evaluator.h"
#include "tests/app/support/glb_pictures.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

/// A material of which most channels vary.
std::string material_json(const std::string& more) {
    return R"({"atlas": {"size": 64}, "solid": {"scale": 3},
        "define": {"grain": {"node": "smoothstep", "low": -1, "high": 1, "input": {"node": "fbm", "octaves": 2}}},
        "material": {)" +
           more +
           R"( "roughness": {"node": "remap", "input": "grain", "out_low": 0.2, "out_high": 0.9},
            "metallic": {"node": "subtract", "a": 1, "b": "grain"}, "occlusion": 0.75,
            "emissive": {"node": "scale", "a": "#ff8020", "b": "grain"}, "emissive_strength": 3,
            "clearcoat": "grain", "clearcoat_roughness": 0.25, "ior": 1.4,
            "height": "grain"}, "bump": {"height": 0.02}})";
}

const std::string opaque_json = material_json(
    R"("base_color": {"node": "mix", "a": "#c9a06a", "b": "#6e4722", "amount": "grain"},)");
const std::string clear_json = material_json(
    R"("base_color": {"node": "mix", "a": "#c9a06a", "b": "#6e4722", "amount": "grain"},
       "opacity": "grain",)");

class MaterialBake : public testing::Test {
  protected:
    BakeResult bake_to(const std::string& name, const std::string& json,
                       const std::function<void(BakePlan&)>& change = {}) {
        RecipeImages images;
        recipe_ = parse_recipe(json, "m.json", {}, images);
        pipeline_.set_recipe(recipe_);
        BakePlan plan;
        plan.paths = {folder_ / name};
        plan.recipe = [&](std::size_t) { return recipe_; };
        plan.kind = wanted_kind(name, 8);
        plan.packing = packing_asked("", name);
        plan.measures = false;
        if (change) change(plan);
        return bake(pipeline_, plan);
    }

    RawPng png(const std::string& name) const { return raw_png(read_file_bytes(folder_ / name)); }

    /// Compares component `c` of a picture with a number of a graph's colour at every texel that a
    /// triangle owns: codes are off by one at most.
    void expect_component(const RawPng& picture, std::size_t c, const std::string& channel,
                          const std::function<double(const GraphSample&)>& code) {
        const std::size_t components = picture.codes.size() / picture.width / picture.height;
        ASSERT_LT(c, components);
        const GraphEvaluator evaluate(channel_texture(recipe_, channel));
        const Affine3 map = texture_from_solid(recipe_);
        const SolidAtlas& solid = pipeline_.solid();
        double lowest = 1e9, highest = -1e9;
        for (std::size_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::uint32_t i = 0; i < span.count; ++i) {
                    const Vec3d point = solid.maps[span.map](span.x + i, std::int64_t(y));
                    const double expected = 255.0 * code(evaluate(map(point)));
                    const std::size_t at = (y * picture.width + span.x + i) * components + c;
                    ASSERT_NEAR(picture.codes[at], expected, 1.0) << channel << " " << y;
                    lowest = std::min(lowest, expected), highest = std::max(highest, expected);
                }
        EXPECT_GT(highest - lowest, 20.0) << channel << " does not vary";
    }

    void expect_number(const RawPng& picture, std::size_t c, const std::string& channel) {
        expect_component(picture, c, channel,
                         [](const GraphSample& s) { return s.channels[0].value; });
    }

    void expect_color(const RawPng& picture, const std::string& channel) {
        for (std::size_t c = 0; c < 3; ++c)
            expect_component(picture, c, channel, [c](const GraphSample& s) {
                const double x = s.channels[c].value;
                return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
            });
    }

    ScratchFolder folder_;
    Pipeline pipeline_{sample_mesh("sample:teapot")};
    Recipe recipe_;
};

TEST_F(MaterialBake, EveryChannelOfAGlbIsItsGraphs) {
    bake_to("a.glb", opaque_json, [](BakePlan& plan) { plan.normals = NormalSpace::tangent; });
    const Glb glb(folder_ / "a.glb");
    const Json& material = glb.document["materials"][0];
    const Json& pbr = material["pbrMetallicRoughness"];
    expect_color(glb.texture(pbr["baseColorTexture"]), "base_color");
    expect_number(glb.texture(pbr["metallicRoughnessTexture"]), 1, "roughness");
    expect_number(glb.texture(pbr["metallicRoughnessTexture"]), 2, "metallic");
    expect_color(glb.texture(material["emissiveTexture"]), "emissive");
    const Json& coat = material["extensions"]["KHR_materials_clearcoat"];
    expect_number(glb.texture(coat["clearcoatTexture"]), 0, "clearcoat");
    // Factors of what varies are 1, and of the rest the recipe's numbers.
    EXPECT_EQ(pbr.value("metallicFactor", 1.0), 1.0);
    EXPECT_EQ(pbr.value("roughnessFactor", 1.0), 1.0);
    EXPECT_EQ(coat["clearcoatFactor"], 1.0);
    EXPECT_EQ(coat["clearcoatRoughnessFactor"], 0.25);
    EXPECT_FALSE(coat.contains("clearcoatRoughnessTexture"));
    EXPECT_EQ(material["emissiveFactor"], Json::parse("[1.0, 1.0, 1.0]"));
    EXPECT_EQ(material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 3.0);
    EXPECT_EQ(material["extensions"]["KHR_materials_ior"]["ior"], 1.4);
    EXPECT_FALSE(material.contains("alphaMode"));
    // Occlusion has no factor in glTF, so its number is in the picture.
    const RawPng& orm = glb.texture(material["occlusionTexture"]);
    EXPECT_EQ(&orm, &glb.texture(pbr["metallicRoughnessTexture"]));
    for (std::size_t i = 0; i < orm.codes.size(); i += 3) ASSERT_EQ(orm.codes[i], 191);
    // base colour, normal, orm, emissive, clearcoat: one picture each, no more.
    EXPECT_EQ(glb.images.size(), 5u);
    EXPECT_TRUE(glb.texture(pbr["baseColorTexture"]).srgb);
    EXPECT_TRUE(glb.texture(material["emissiveTexture"]).srgb);
    EXPECT_FALSE(orm.srgb);
}

TEST_F(MaterialBake, AlphaIsTheColoursTimesTheOpacity) {
    bake_to("a.glb", clear_json);
    const Glb glb(folder_ / "a.glb");
    const Json& material = glb.document["materials"][0];
    const RawPng& color = glb.texture(material["pbrMetallicRoughness"]["baseColorTexture"]);
    expect_number(color, 3, "alpha");
    expect_color(color, "base_color");  // the colour itself is opaque: codes are not multiplied
    EXPECT_EQ(material["alphaMode"], "BLEND");
    bake_to("b.glb", clear_json, [&](BakePlan& plan) {
        recipe_.material.alpha = AlphaMode::mask;
        recipe_.material.alpha_cutoff = 0.3;
        pipeline_.set_recipe(recipe_);
        plan.recipe = [&](std::size_t) { return recipe_; };
    });
    const Json masked = Glb(folder_ / "b.glb").document["materials"][0];
    EXPECT_EQ(masked["alphaMode"], "MASK");
    EXPECT_EQ(masked["alphaCutoff"], 0.3);
}

TEST_F(MaterialBake, PngsHoldAChannelEach) {
    bake_to("a.png", opaque_json);
    expect_color(png("a.png"), "base_color");
    for (const char* channel : {"roughness", "metallic", "clearcoat"}) {
        const RawPng picture = png(std::string("a_") + channel + ".png");
        EXPECT_EQ(picture.color_type, PNG_COLOR_TYPE_GRAY);
        expect_number(picture, 0, channel);
    }
    expect_color(png("a_emissive.png"), "emissive");
    EXPECT_EQ(folder_.entries(), 5u);  // what does not vary has no picture
}

TEST_F(MaterialBake, EnginesHaveTheirOwnOrder) {
    bake_to("a.png", opaque_json, [](BakePlan& plan) { plan.packing = Packing::unity; });
    const RawPng mask = png("a_mask.png");
    expect_number(mask, 0, "metallic");
    expect_component(mask, 3, "roughness",
                     [](const GraphSample& s) { return 1.0 - s.channels[0].value; });
    for (std::size_t i = 0; i < mask.codes.size(); i += 4) {
        ASSERT_EQ(mask.codes[i + 1], 191);
        ASSERT_EQ(mask.codes[i + 2], 0);
    }
    for (const Packing packing : {Packing::unreal, Packing::godot}) {
        bake_to("b.png", opaque_json, [&](BakePlan& plan) { plan.packing = packing; });
        expect_number(png("b_orm.png"), 1, "roughness");
        expect_number(png("b_orm.png"), 2, "metallic");
    }
}

TEST_F(MaterialBake, NormalsOfDirectXPointDown) {
    const auto with = [&](const char* name, bool down) {
        bake_to(name, opaque_json, [&](BakePlan& plan) {
            plan.normals = NormalSpace::tangent;
            plan.normals_down = down;
        });
        return png(std::string(name).replace(1, 4, "_normal.png"));
    };
    const RawPng up = with("a.png", false), down = with("b.png", true);
    std::size_t turned = 0;
    for (std::size_t i = 0; i < up.codes.size(); ++i) {
        ASSERT_EQ(down.codes[i], i % 3 == 1 ? 255 - up.codes[i] : up.codes[i]) << i;
        turned += i % 3 == 1 && up.codes[i] != down.codes[i];
    }
    EXPECT_GT(turned, up.codes.size() / 6);
}

TEST_F(MaterialBake, LevelsAreMeansOfEveryPicture) {
    bake_to("a.png", opaque_json, [](BakePlan& plan) { plan.levels.count = 2; });
    for (const char* name : {"a", "a_metallic", "a_emissive"})
        for (const auto& [level, size] : {std::pair(1, 32u), std::pair(2, 16u)}) {
            const RawPng picture = png(fmt::format("{}.{}.png", name, level));
            EXPECT_EQ(picture.width, size) << name;
        }
    const RawPng fine = png("a_metallic.png"), coarse = png("a_metallic.1.png");
    // A coarse texel inside one chart is the mean of the four that it covers.
    std::size_t means = 0;
    for (std::size_t y = 0; y < 32; ++y)
        for (std::size_t x = 0; x < 32; ++x) {
            double mean = 0.0;
            for (const std::size_t i : {0u, 1u, 64u, 65u}) mean += fine.codes[128 * y + 2 * x + i];
            means += std::abs(coarse.codes[32 * y + x] - mean / 4) <= 1.0;
        }
    EXPECT_GT(means, 32u * 32u / 2);
}

TEST_F(MaterialBake, SharpLevelsAreThoseOfColours) {
    const auto levels_of = [&](bool sharp) {
        bake_to("a.png", opaque_json, [&](BakePlan& plan) { plan.levels = {1, {.sharp = sharp}}; });
        std::vector<std::vector<std::uint16_t>> codes;
        for (const char* name : {"a", "a_emissive", "a_metallic", "a_roughness", "a_clearcoat"})
            codes.push_back(png(fmt::format("{}.1.png", name)).codes);
        return codes;
    };
    const auto means = levels_of(false), sharp = levels_of(true);
    for (std::size_t i = 0; i < means.size(); ++i) EXPECT_EQ(means[i] != sharp[i], i < 2) << i;
}

TEST_F(MaterialBake, LevelsOfSmoothnessAreLessWhereNormalsAverage) {
    const std::string rough = R"({"atlas": {"size": 64}, "solid": {"scale": 20},
        "material": {"roughness": 0, "height": {"node": "fbm"}}, "bump": {"height": 0.2}})";
    bake_to("a.png", rough, [](BakePlan& plan) {
        plan.packing = Packing::unity;
        plan.normals = NormalSpace::tangent;
        plan.levels.count = 2;
    });
    const RawPng fine = png("a_mask.png"), coarse = png("a_mask.1.png");
    double lowest = 255;
    for (std::size_t i = 3; i < fine.codes.size(); i += 4) ASSERT_EQ(fine.codes[i], 255);
    for (std::size_t i = 3; i < coarse.codes.size(); i += 4)
        lowest = std::min(lowest, double(coarse.codes[i]));
    EXPECT_LT(lowest, 200);
}

TEST_F(MaterialBake, AnObjNamesThePackedPictureInsteadOfANumber) {
    bake_to("a.obj", opaque_json, [](BakePlan& plan) { plan.packing = Packing::unreal; });
    const std::vector<std::uint8_t> bytes = read_file_bytes(folder_ / "a.mtl");
    const std::string mtl(bytes.begin(), bytes.end());
    EXPECT_NE(mtl.find("# roughness and metallic: a_orm.png"), std::string::npos) << mtl;
    EXPECT_EQ(mtl.find("\nPr "), std::string::npos);
    bake_to("b.obj", opaque_json);
    const std::vector<std::uint8_t> own = read_file_bytes(folder_ / "b.mtl");
    EXPECT_NE(std::string(own.begin(), own.end()).find("map_Pr b_roughness.png"),
              std::string::npos);
}

TEST(MaterialValues, ThoseThatNoFileHoldsAreNamed) {
    RecipeImages images;
    const Recipe recipe = parse_recipe(
        R"({"texture": {"node": "fbm"}, "material": {"metallic": {"node": "fbm"}, "roughness": 0.5,
            "occlusion": 0.75, "emissive": "#ff8000", "emissive_strength": 4, "ior": 1.25,
            "clearcoat": {"node": "fbm"}, "clearcoat_roughness": 0.125, "sheen": "#102030",
            "sheen_roughness": 0.5, "transmission": 0.25}})",
        "m.json", {}, images);
    const auto unheld = [&](const std::string& out, Packing packing,
                            const std::vector<std::string>& pictures) {
        const std::string sentence = values_not_held(recipe, pictures, packing, out);
        return sentence.substr(sentence.find(": ") + 2);
    };
    const std::string sheen = "sheen #102030, sheen_roughness 0.5, transmission 0.25";
    const std::vector<std::string> apart{"metallic", "clearcoat"}, packed{"orm", "clearcoat"};
    EXPECT_EQ(unheld("a.png", Packing::separate, apart),
              "roughness 0.5, occlusion 0.75, emissive #ff8000, clearcoat_roughness 0.125, " +
                  sheen + ", ior 1.25, emissive_strength 4");
    EXPECT_EQ(unheld("a.ply", Packing::unreal, packed),
              "emissive #ff8000, " + sheen + ", ior 1.25, emissive_strength 4");
    EXPECT_EQ(unheld("a.obj", Packing::separate, apart), "occlusion 0.75, " + sheen);
    for (const char* out : {"a.glb", "a.gltf", "a.mtlx", "a.stl"})
        EXPECT_EQ(values_not_held(recipe, {}, Packing::gltf, out), "") << out;
    EXPECT_EQ(values_not_held(Recipe(), {}, Packing::separate, "a.ply"), "");
}

TEST_F(MaterialBake, PaintOverATransparentTextureIsRefused) {
    const std::string painted =
        clear_json.substr(0, clear_json.size() - 1) + R"(, "paint": [{"points": [[0, 0, 0]]}]})";
    EXPECT_THROW(bake_to("a.glb", painted), Error);
    EXPECT_THROW(bake_to("a.exr", painted), Error);
}

TEST_F(MaterialBake, AnExrHasALayerPerChannel) {
    bake_to("a.exr", opaque_json);
    const Imf::InputFile file((folder_ / "a.exr").c_str());
    const Imf::ChannelList& channels = file.header().channels();
    for (const char* name : {"R", "G", "B", "roughness.Y", "metallic.Y", "clearcoat.Y",
                             "emissive.R", "emissive.G", "emissive.B"})
        EXPECT_NE(channels.findChannel(name), nullptr) << name;
    std::size_t count = 0;
    for (auto c = channels.begin(); c != channels.end(); ++c) ++count;
    EXPECT_EQ(count, 9u);
}

}  // namespace
}  // namespace burl
