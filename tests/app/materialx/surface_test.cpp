// Surface shaders as channels of a recipe, and what is said of what is lost.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/materialx/materialx.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/json.h"

namespace burl {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string input(const std::string& name, const std::string& type, const std::string& value) {
    return "<input name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

MaterialXRecipe recipe_of(const std::string& shader, const std::string& inputs,
                          const std::string& nodes = "", const std::string& material = "") {
    return recipe_of_materialx(
        "<materialx version=\"1.39\" colorspace=\"lin_rec709\">" + nodes + "<" + shader +
            " name=\"S\" type=\"surfaceshader\">" + inputs + "</" + shader +
            "><surfacematerial name=\"M\" type=\"material\"><input name=\"surfaceshader\" "
            "type=\"surfaceshader\" nodename=\"S\"/>" +
            material + "</surfacematerial></materialx>",
        "m.mtlx");
}

Json json_of(const MaterialXRecipe& recipe) {
    parse_recipe(recipe.json, "m.mtlx");  // which throws where it is no recipe
    return Json::parse(recipe.json);
}

TEST(MaterialXSurface, StandardSurfaceFillsTheChannels) {
    const MaterialXRecipe recipe = recipe_of(
        "standard_surface",
        input("base", "float", "0.5") + input("base_color", "color3", "0.4, 0.4, 0.4") +
            input("metalness", "float", "0.25") + input("specular", "float", "0.75") +
            input("specular_roughness", "float", "0.35") + input("specular_IOR", "float", "1.6") +
            input("coat", "float", "0.8") + input("coat_roughness", "float", "0.05") +
            input("sheen", "float", "0.5") + input("sheen_color", "color3", "0.5, 0.5, 0.5") +
            input("emission", "float", "3") + input("emission_color", "color3", "0.5, 0.5, 0.5") +
            input("opacity", "color3", "0.9, 0.9, 0.9"));
    const Json json = json_of(recipe);
    EXPECT_NEAR(json["texture"]["value"], 0.2, 1e-12);
    const Json& material = json["material"];
    EXPECT_EQ(material["metallic"], 0.25);
    EXPECT_EQ(material["specular"], 0.75);
    EXPECT_EQ(material["roughness"], 0.35);
    EXPECT_EQ(material["ior"], 1.6);
    EXPECT_EQ(material["clearcoat"], 0.8);
    EXPECT_EQ(material["clearcoat_roughness"], 0.05);
    EXPECT_EQ(material["sheen"]["value"], 0.25);
    EXPECT_EQ(material["sheen_roughness"], 0.3);
    EXPECT_EQ(material["emissive_strength"], 3.0);
    EXPECT_EQ(material["emissive"]["value"], 0.5);
    EXPECT_EQ(material["opacity"], 0.9);
    EXPECT_EQ(json["solid"]["space"], "object");
    EXPECT_THAT(recipe.losses, IsEmpty());
}

TEST(MaterialXSurface, OpenPbrFillsTheChannels) {
    const MaterialXRecipe recipe = recipe_of(
        "open_pbr_surface",
        input("base_weight", "float", "0.5") + input("base_color", "color3", "0.4, 0.4, 0.4") +
            input("base_metalness", "float", "1") + input("specular_roughness", "float", "0.5") +
            input("fuzz_weight", "float", "0.5") + input("geometry_opacity", "float", "0.5"));
    const Json json = json_of(recipe);
    EXPECT_NEAR(json["texture"]["value"], 0.2, 1e-12);
    EXPECT_EQ(json["material"]["metallic"], 1.0);
    EXPECT_EQ(json["material"]["roughness"], 0.5);
    EXPECT_EQ(json["material"]["sheen"]["value"], 0.5);
    EXPECT_EQ(json["material"]["sheen_roughness"], 0.5);
    EXPECT_EQ(json["material"]["opacity"], 0.5);
    EXPECT_THAT(recipe.losses, IsEmpty());
}

TEST(MaterialXSurface, ARoughCoatRoughensWhatIsBelow) {
    // (2 * 0.5^4 + 0.3^4)^(1/4), OpenPBR 1.1, "Roughening".
    const Json json =
        json_of(recipe_of("open_pbr_surface", input("coat_weight", "float", "1") +
                                                  input("coat_roughness", "float", "0.5")));
    EXPECT_NEAR(json["material"]["roughness"], 0.604, 1e-3);
}

TEST(MaterialXSurface, DefaultsDependOnTheVersionOfTheShader) {
    EXPECT_EQ(json_of(recipe_of("standard_surface", ""))["texture"]["value"], 0.8);
    EXPECT_EQ(json_of(recipe_of("open_pbr_surface", ""))["texture"]["value"], 0.8);
    EXPECT_EQ(json_of(recipe_of("open_pbr_surface", ""))["material"]["roughness"], 0.3);
    EXPECT_EQ(json_of(recipe_of("standard_surface", ""))["material"]["roughness"], 0.2);
}

TEST(MaterialXSurface, NamesWhatNoChannelHolds) {
    const MaterialXRecipe recipe = recipe_of(
        "standard_surface",
        input("specular_anisotropy", "float", "0.5") + input("thin_film_IOR", "float", "2") +
            input("coat_IOR", "float", "2") + input("thin_walled", "boolean", "true") +
            input("specular_color", "color3", "1, 1, 1") + input("shine", "float", "1"));
    // Without a film and a coat their refractive indices have no effect.
    EXPECT_THAT(recipe.losses,
                ElementsAre("m.mtlx: S: a recipe has no channel for specular_anisotropy, "
                            "thin_walled",
                            "m.mtlx: S: standard_surface has no input shine, which is left out"));
}

TEST(MaterialXSurface, SubsurfaceIsMixedIntoTheColorAndSaid) {
    const MaterialXRecipe recipe =
        recipe_of("standard_surface", input("base_color", "color3", "0.2, 0.2, 0.2") +
                                          input("subsurface", "float", "0.5") +
                                          input("subsurface_color", "color3", "0.6, 0.6, 0.6"));
    EXPECT_NEAR(json_of(recipe)["texture"]["value"], 0.4, 1e-12);
    ASSERT_EQ(recipe.losses.size(), 1u);
    EXPECT_THAT(recipe.losses[0], HasSubstr("subsurface scatters no light"));
}

const std::string noise = "<noise3d name=\"N\" type=\"float\"/>";

TEST(MaterialXSurface, DisplacementAndBumpsAreHeights) {
    const std::string displacement = noise +
                                     "<displacement name=\"D\" type=\"displacementshader\"><input "
                                     "name=\"displacement\" type=\"float\" nodename=\"N\"/>" +
                                     input("scale", "float", "0.5") + "</displacement>";
    const Json json =
        json_of(recipe_of("standard_surface", "", displacement,
                          "<input name=\"displacementshader\" type=\"displacementshader\" "
                          "nodename=\"D\"/>"));
    EXPECT_EQ(json["bump"]["height"], 1);
    EXPECT_EQ(json["bump"]["input"]["node"], "multiply");
    EXPECT_EQ(json["bump"]["input"]["b"], 0.5);

    const std::string bump = noise +
                             "<bump name=\"B\" type=\"vector3\"><input name=\"height\" "
                             "type=\"float\" nodename=\"N\"/></bump>";
    const MaterialXRecipe bumpy = recipe_of(
        "standard_surface", "<input name=\"normal\" type=\"vector3\" nodename=\"B\"/>", bump);
    EXPECT_EQ(json_of(bumpy)["bump"]["input"]["node"], "materialx_noise");
}

TEST(MaterialXSurface, ANormalThatIsNoHeightIsLostAndSaid) {
    const MaterialXRecipe recipe =
        recipe_of("standard_surface", "<input name=\"normal\" type=\"vector3\" nodename=\"M1\"/>",
                  "<normalmap name=\"M1\" type=\"vector3\"/>");
    EXPECT_FALSE(json_of(recipe).contains("bump"));
    ASSERT_EQ(recipe.losses.size(), 1u);
    EXPECT_THAT(recipe.losses[0], HasSubstr("normal is left out, since M1 (normalmap)"));
}

TEST(MaterialXSurface, ColorsAreTakenToLinearLight) {
    const auto base_of = [](const std::string& space) {
        return json_of(recipe_of("standard_surface",
                                 "<input name=\"base_color\" type=\"color3\" "
                                 "value=\"0.5, 0.5, 0.5\" colorspace=\"" +
                                     space + "\"/>"))["texture"]["value"]
            .get<double>();
    };
    EXPECT_NEAR(base_of("srgb_texture"), 0.21404114, 1e-8);
    EXPECT_NEAR(base_of("lin_rec709"), 0.5, 1e-15);
    EXPECT_NEAR(base_of("g22_rec709"), 0.21763764, 1e-8);
}

TEST(MaterialXSurface, TheLongFormOfNodesIsTheSame) {
    const std::string s = "<input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"S\"/>";
    const MaterialXRecipe recipe = recipe_of_materialx(
        "<materialx version=\"1.39\"><node nodetype=\"standard_surface\" name=\"S\" "
        "type=\"surfaceshader\"/><node nodetype=\"surfacematerial\" name=\"M\" "
        "type=\"material\">" +
            s + "</node></materialx>",
        "m.mtlx");
    EXPECT_EQ(json_of(recipe)["texture"]["value"], 0.8);
}

}  // namespace
}  // namespace burl
