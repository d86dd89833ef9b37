// Documents of baked materials: which input of standard_surface is fed by which picture or number.
#include "app/materialx/write/surface.h"

#include "tests/app/support/xml_elements.h"

namespace burl::materialx {
namespace {

/// The value of an input of the surface, or the output that feeds it; empty: it is left out.
std::string surface_input(const std::string& document, const std::string& name) {
    for (const FoundElement& one : xml_elements(document))
        if (one.tag == "input" && one.inside.starts_with("SR_") && one["name"] == name)
            return one["value"].empty() ? "output " + one["output"] : one["value"];
    return "";
}

/// The picture and the colour space of the image of a channel.
std::string image_of(const std::string& document, const std::string& channel) {
    for (const FoundElement& one : xml_elements(document))
        if (one.inside == channel + "_image" && one["name"] == "file")
            return one["value"] + ' ' + one["colorspace"];
    return "";
}

bool has_node(const std::string& document, const std::string& category) {
    for (const FoundElement& one : xml_elements(document))
        if (one.tag == category) return true;
    return false;
}

TEST(MaterialXBakedSurface, NumbersAreInputsAndDefaultsOfLayersAreLeftOut) {
    const auto [text, lost] = surface_document(
        {.name = "cube & co", .material = {.metallic = 0.25, .roughness = 0.5}, .color = "a.png"});
    expect_whole_document(text);
    EXPECT_EQ(lost, "");
    EXPECT_EQ(image_of(text, "base_color"), "a.png srgb_texture");
    EXPECT_EQ(surface_input(text, "base_color"), "output base_color");
    EXPECT_EQ(surface_input(text, "metalness"), "0.25");
    EXPECT_EQ(surface_input(text, "specular_roughness"), "0.5");
    EXPECT_EQ(surface_input(text, "specular_IOR"), "1.5");
    for (const char* none : {"coat", "sheen", "transmission", "emission", "opacity", "normal"})
        EXPECT_EQ(surface_input(text, none), "") << none;
    EXPECT_TRUE(text.find("name=\"cube___co\"") != std::string::npos);
}

TEST(MaterialXBakedSurface, EveryChannelHasItsInput) {
    BakedSurface baked{.name = "all", .color = "a.png", .normals = "a_normal.png"};
    for (const char* channel :
         {"metallic", "roughness", "occlusion", "emissive", "specular", "clearcoat",
          "clearcoat_roughness", "sheen", "sheen_roughness", "transmission"})
        baked.pictures.emplace_back(channel, std::string("a_") + channel + ".png");
    baked.material.emissive_strength = 6.0;
    const auto [text, lost] = surface_document(baked);
    expect_whole_document(text);
    const std::vector<std::pair<std::string, std::string>> inputs{
        {"metalness", "metallic"},
        {"specular_roughness", "roughness"},
        {"emission_color", "emissive"},
        {"specular", "specular"},
        {"coat", "clearcoat"},
        {"coat_roughness", "clearcoat_roughness"},
        {"sheen_color", "sheen"},
        {"sheen_roughness", "sheen_roughness"},
        {"transmission", "transmission"},
        {"normal", "normal"}};
    for (const auto& [input, channel] : inputs) {
        EXPECT_EQ(surface_input(text, input), "output " + channel);
        const bool colored = channel == "emissive" || channel == "sheen";
        EXPECT_EQ(image_of(text, channel),
                  "a_" + channel + ".png " + (colored ? "srgb_texture" : ""));
    }
    EXPECT_EQ(surface_input(text, "emission"), "6");
    EXPECT_EQ(surface_input(text, "sheen"), "1");
    EXPECT_EQ(surface_input(text, "transmission_color"), "output base_color");
    EXPECT_EQ(surface_input(text, "thin_walled"), "true");
    // standard_surface has no occlusion.
    EXPECT_EQ(image_of(text, "occlusion"), "a_occlusion.png ");
    EXPECT_NE(lost.find("occlusion"), std::string::npos);
}

TEST(MaterialXBakedSurface, ColoursThatDoNotVaryAreInLinearLight) {
    const auto [text, lost] = surface_document(
        {.name = "a",
         .material = {.occlusion = 0.5, .emissive = {255, 0, 188}, .sheen = {0, 255, 0}},
         .color = "a.png"});
    EXPECT_EQ(surface_input(text, "sheen_color"), "0, 1, 0");
    const std::string emission = surface_input(text, "emission_color");
    EXPECT_TRUE(emission.starts_with("1, 0, 0.50")) << emission;  // IEC 61966-2-1
    EXPECT_NE(lost.find("0.5"), std::string::npos) << lost;
}

TEST(MaterialXBakedSurface, AlphaIsTheOpacity) {
    BakedSurface baked{.name = "a", .color = "a.png", .has_alpha = true};
    const std::string blended = surface_document(baked).text;
    expect_whole_document(blended);
    EXPECT_EQ(surface_input(blended, "opacity"), "output opacity");
    EXPECT_FALSE(has_node(blended, "ifgreatereq"));
    baked.alpha_cutoff = 0.5;
    const std::string cut = surface_document(baked).text;
    expect_whole_document(cut);
    EXPECT_TRUE(has_node(cut, "ifgreatereq"));
}

TEST(MaterialXBakedSurface, NormalsOfEitherSpace) {
    BakedSurface baked{.name = "a", .color = "a.png", .normals = "n.png", .closest = true};
    const std::string tangent = surface_document(baked).text;
    EXPECT_TRUE(has_node(tangent, "normalmap"));
    EXPECT_NE(tangent.find("\"closest\""), std::string::npos);
    baked.tangent_space = false;
    const std::string object = surface_document(baked).text;
    expect_whole_document(object);
    EXPECT_FALSE(has_node(object, "normalmap"));
    EXPECT_TRUE(has_node(object, "transformnormal"));
}

}  // namespace
}  // namespace burl::materialx
