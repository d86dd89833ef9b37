#include "tests/app/support/kept_samples.h"

#include <algorithm>
#include <functional>

namespace burl {
namespace {

using Json = GltfDraft::Json;

using Change = std::function<void(Bar&)>;

void two_materials(Bar& d) {
    d.material({{"name", "Wood old"},
                {"doubleSided", true},
                {"extras", {{"grain", 3}}},
                {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", d.add_texture("a")}}}}}});
    d.material({{"name", "Metal"},
                {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", d.add_texture("b")}}}}}});
    Json other = d.first();
    const auto half = d.arrays.indices.begin() + 240;
    d.first()["indices"] =
        d.add(std::vector<std::uint16_t>(d.arrays.indices.begin(), half), 5123, "SCALAR", 1);
    other["indices"] =
        d.add(std::vector<std::uint16_t>(half, d.arrays.indices.end()), 5123, "SCALAR", 1);
    d.first()["material"] = 0;
    other["material"] = 1;
    d.json["meshes"][0]["primitives"].push_back(other);
}

void quantise(Bar& d) {
    d.use("KHR_mesh_quantization");
    d.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    std::vector<std::int16_t> positions;
    std::vector<std::int8_t> normals;
    std::vector<std::uint16_t> uvs;
    for (std::size_t v = 0; v < d.arrays.count(); ++v) {
        for (std::size_t k = 0; k < 4; ++k) {
            const float p = k < 3 ? d.arrays.positions[3 * v + k] : 0.0f;
            const float n = k < 3 ? d.arrays.normals[3 * v + k] : 0.0f;
            positions.push_back(std::int16_t(p * 8000.0f));
            normals.push_back(std::int8_t(std::lround(n * 127.0f)));
        }
        for (std::size_t k = 0; k < 2; ++k)
            uvs.push_back(std::uint16_t(d.arrays.uvs[2 * v + k] * 65535.0f));
    }
    const auto add = [&](std::size_t view, int type, const char* shape, bool normalized) {
        d.json["accessors"].push_back({{"bufferView", view},
                                       {"componentType", type},
                                       {"normalized", normalized},
                                       {"count", d.arrays.count()},
                                       {"type", shape}});
        return d.json["accessors"].size() - 1;
    };
    const std::size_t p =
        add(d.view(positions, {{"byteStride", 8}, {"target", 34962}}), 5122, "VEC3", false);
    std::vector<std::int16_t> packed;
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (i % 4 < 3) packed.push_back(positions[i]);
    Bar::add_bounds(d.json["accessors"][p], packed, 3);
    d.attributes() = {{"POSITION", p},
                      {"NORMAL", add(d.view(normals, {{"byteStride", 4}, {"target", 34962}}), 5120,
                                     "VEC3", true)},
                      {"TEXCOORD_0", add(d.view(uvs, {{"byteStride", 4}, {"target", 34962}}), 5123,
                                         "VEC2", true)}};
    d.json["nodes"][0]["scale"] = {0.000125, 0.000125, 0.000125};
}

void interleave(Bar& d) {
    std::vector<float> mixed;
    for (std::size_t v = 0; v < d.arrays.count(); ++v) {
        mixed.insert(mixed.end(), &d.arrays.positions[3 * v], &d.arrays.positions[3 * v] + 3);
        mixed.insert(mixed.end(), &d.arrays.normals[3 * v], &d.arrays.normals[3 * v] + 3);
        mixed.insert(mixed.end(), &d.arrays.uvs[2 * v], &d.arrays.uvs[2 * v] + 2);
    }
    const std::size_t view = d.view(mixed, {{"byteStride", 32}, {"target", 34962}});
    const auto add = [&](std::size_t offset, const char* shape) {
        d.json["accessors"].push_back({{"bufferView", view},
                                       {"byteOffset", offset},
                                       {"componentType", 5126},
                                       {"count", d.arrays.count()},
                                       {"type", shape}});
        return d.json["accessors"].size() - 1;
    };
    const std::size_t position = add(0, "VEC3");
    Bar::add_bounds(d.json["accessors"][position], d.arrays.positions, 3);
    d.attributes() = {
        {"POSITION", position}, {"NORMAL", add(12, "VEC3")}, {"TEXCOORD_0", add(24, "VEC2")}};
}

void sparse_positions(Bar& d) {
    const std::vector<std::uint16_t> numbers{3, 20, 40};
    const std::vector<float> places{0.4f, 0.1f, 0.0f, 0.2f, 0.3f, 0.4f, -0.4f, 1.0f, 0.1f};
    Json& accessor = d.json["accessors"][d.attributes()["POSITION"].get<std::size_t>()];
    accessor["sparse"] = {{"count", 3},
                          {"indices", {{"bufferView", d.view(numbers)}, {"componentType", 5123}}},
                          {"values", {{"bufferView", d.view(places)}}}};
    accessor["min"] = accessor["max"] = Json::array();
    std::vector<float> positions = d.arrays.positions;
    for (std::size_t i = 0; i < 3; ++i)
        std::copy_n(&places[3 * i], 3, &positions[3 * std::size_t(numbers[i])]);
    Bar::add_bounds(accessor, positions, 3);
}

void strips(Bar& d) {
    std::vector<std::uint16_t> strip;
    for (std::size_t j = 0; j + 1 < BarArrays::along; ++j) {
        if (j > 0) strip.insert(strip.end(), {strip.back(), std::uint16_t(j * 11)});
        for (std::size_t i = 0; i <= BarArrays::around; ++i)
            strip.insert(strip.end(), {std::uint16_t(j * 11 + i), std::uint16_t(j * 11 + 11 + i)});
    }
    d.first()["indices"] = d.add(strip, 5123, "SCALAR", 1);
    d.first()["mode"] = 5;
}

void fans(Bar& d) {
    std::vector<std::uint16_t> fan{0};
    for (std::uint16_t i = 11; i < 22; ++i) fan.push_back(i);
    d.first()["indices"] = d.add(fan, 5123, "SCALAR", 1);
    d.first()["mode"] = 6;
}

void unindexed(Bar& d) {
    std::vector<float> positions, uvs;
    for (const std::uint16_t i : d.arrays.indices) {
        positions.insert(positions.end(), &d.arrays.positions[3 * i],
                         &d.arrays.positions[3 * i] + 3);
        uvs.insert(uvs.end(), &d.arrays.uvs[2 * i], &d.arrays.uvs[2 * i] + 2);
    }
    d.first().erase("indices");
    d.attributes() = {{"POSITION", d.bounded(positions, 3)}, {"TEXCOORD_0", d.floats(uvs, 2)}};
}

void hierarchy(Bar& d) {
    d.json["nodes"] = Json::array({{{"name", "root"}, {"children", {1, 3}}, {"scale", {2, 2, 2}}},
                                   {{"name", "arm"}, {"children", {2}}, {"translation", {0, 1, 0}}},
                                   {{"name", "hand"},
                                    {"mesh", 0},
                                    {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1}}},
                                   {{"name", "empty"}}});
}

void lights(Bar& d) {
    d.use("KHR_lights_punctual");
    d.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "point"}, {"intensity", 40}, {"name", "lamp"}}});
    d.json["nodes"].push_back(
        {{"name", "lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    d.json["scenes"][0]["nodes"].push_back(1);
}

void cameras(Bar& d) {
    d.json["cameras"] =
        Json::array({{{"type", "perspective"},
                      {"name", "front"},
                      {"perspective", {{"yfov", 0.7}, {"znear", 0.1}, {"zfar", 100}}}},
                     {{"type", "orthographic"},
                      {"orthographic", {{"xmag", 2}, {"ymag", 2}, {"znear", 0.1}, {"zfar", 10}}}}});
    d.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 1, 5}}});
    d.json["nodes"].push_back({{"camera", 1}, {"name", "top"}});
    d.json["scenes"][0]["nodes"] = {0, 1, 2};
}

void extras(Bar& d) {
    d.json["extras"] = {{"tool", "x"}, {"list", {1, 2.5, "three", nullptr, true}}};
    d.json["nodes"][0]["extras"] = {{"id", 77}};
    d.json["scenes"][0]["extras"] = {{"weather", "rain"}};
    d.json["meshes"][0]["extras"] = {{"lod", 0}};
    d.first()["extras"] = {{"part", "bar"}};
    d.json["asset"]["extras"] = {{"author", "somebody"}};
}

void unknown_extension(Bar& d) {
    d.use("ACME_physics");
    d.json["extensions"]["ACME_physics"] = {{"gravity", 9.81}};
    d.json["nodes"][0]["extensions"]["ACME_physics"] = {{"mass", 3}};
    d.first()["extensions"]["ACME_physics"] = {{"collides", true}};
}

void variants(Bar& d) {
    d.use("KHR_materials_variants");
    d.material({{"name", "day"}});
    d.material({{"name", "night"}, {"emissiveFactor", {1, 1, 0}}});
    d.json["extensions"]["KHR_materials_variants"]["variants"] =
        Json::array({{{"name", "day"}}, {{"name", "night"}}});
    d.first()["material"] = 0;
    d.first()["extensions"]["KHR_materials_variants"]["mappings"] =
        Json::array({{{"material", 0}, {"variants", {0}}}, {{"material", 1}, {"variants", {1}}}});
}

void textured_neighbour(Bar& d) {
    d.add_second_mesh("lamp shade");
    d.use("KHR_texture_transform");
    d.use("KHR_materials_unlit");
    const std::size_t a = d.add_texture("old"), b = d.add_texture("kept");
    d.material(
        {{"name", "Wood"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", a}}}}}});
    d.material({{"name", "Shade"},
                {"extensions", {{"KHR_materials_unlit", Json::object()}}},
                {"pbrMetallicRoughness",
                 {{"baseColorTexture",
                   {{"index", b},
                    {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}}}}}}}});
    d.first()["material"] = 0;
    d.json["meshes"][1]["primitives"][0]["material"] = 1;
}

void instances(Bar& d) {
    for (const double x : {2.0, 4.0}) {
        d.json["nodes"].push_back({{"mesh", 0}, {"name", "copy"}, {"translation", {x, 0, 0}}});
        d.json["scenes"][0]["nodes"].push_back(d.json["nodes"].size() - 1);
    }
    d.json["nodes"][2]["scale"] = {-1, 1, 1};
}

void gpu_instances(Bar& d) {
    d.use("EXT_mesh_gpu_instancing");
    d.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
        d.floats({0, 0, 0, 3, 0, 0, 6, 0, 0}, 3);
}

void whole_weights(Bar& d) {
    d.add_skin();
    std::vector<std::uint8_t> weights;
    for (std::size_t v = 0; v < d.arrays.count(); ++v) {
        const auto a = std::uint8_t(std::lround(d.arrays.weights[4 * v] * 255.0f));
        weights.insert(weights.end(), {a, std::uint8_t(255 - a), 0, 0});
    }
    d.attributes()["WEIGHTS_0"] = d.add(weights, 5121, "VEC4", 4, {{"normalized", true}});
}

void two_skin_sets(Bar& d) {
    d.add_skin();
    std::vector<float> first = d.arrays.weights, second(first.size(), 0.0f);
    std::vector<std::uint8_t> joints(first.size(), 0);
    for (std::size_t v = 0; v < d.arrays.count(); ++v) {
        second[4 * v] = 0.25f;
        joints[4 * v] = 2;
        for (std::size_t k = 0; k < 4; ++k) first[4 * v + k] *= 0.75f;
    }
    d.attributes()["WEIGHTS_0"] = d.floats(first, 4);
    d.attributes()["WEIGHTS_1"] = d.floats(second, 4);
    d.attributes()["JOINTS_1"] = d.add(joints, 5121, "VEC4", 4);
}

void morph_animation(Bar& d) {
    d.add_targets();
    d.add_animation(0, "weights", {0, 0, 1, 0.5f, 0, 1}, 1);
}

void sparse_targets(Bar& d) {
    d.add_targets();
    d.json["accessors"].push_back({{"componentType", 5126},
                                   {"count", d.arrays.count()},
                                   {"type", "VEC3"},
                                   {"min", {0, 0, 0}},
                                   {"max", {0.5, 0.5, 0}}});
    Json& zero = d.json["accessors"].back();
    const std::size_t number = d.json["accessors"].size() - 1;
    Json sparse = zero;
    zero["max"] = {0, 0, 0};
    sparse["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", d.view(std::vector<std::uint16_t>{7})}, {"componentType", 5123}}},
        {"values", {{"bufferView", d.view(std::vector<float>{0.5f, 0.5f, 0.0f})}}}};
    d.json["accessors"].push_back(sparse);
    d.first()["targets"] = Json::array({{{"POSITION", number}}, {{"POSITION", number + 1}}});
}

void cubic_animation(Bar& d) {
    std::vector<float> keys;
    for (int i = 0; i < 9; ++i)
        keys.insert(keys.end(), {0.1f * float(i), 0.2f, -0.3f * float(i % 2)});
    d.add_animation(0, "translation", keys, 3, "CUBICSPLINE");
}

void second_scene(Bar& d) {
    d.add_second_mesh("other");
    d.json["scenes"] =
        Json::array({{{"nodes", {0}}, {"name", "one"}}, {{"nodes", {1}}, {"name", "two"}}});
}

void lines_beside(Bar& d) {
    Json lines = {{"attributes", {{"POSITION", d.bounded({0, 0, 0, 1, 1, 1}, 3)}}}, {"mode", 1}};
    d.json["meshes"][0]["primitives"].push_back(lines);
}

void more_attributes(Bar& d) {
    d.attributes()["TEXCOORD_1"] = d.floats(d.arrays.uvs, 2);
    d.attributes()["COLOR_0"] = d.floats(d.arrays.colors, 4);
    d.attributes()["_TEMPERATURE"] =
        d.floats(std::vector<float>(d.arrays.uvs.begin(),
                                    d.arrays.uvs.begin() + std::ptrdiff_t(d.arrays.count())),
                 1);
}

void byte_colors(Bar& d) {
    std::vector<std::uint8_t> colors;
    for (const float c : d.arrays.colors) colors.push_back(std::uint8_t(std::lround(c * 255.0f)));
    d.attributes()["COLOR_0"] = d.add(colors, 5121, "VEC4", 4, {{"normalized", true}});
}

void lone_image(Bar& d) {
    d.add_texture("unused");
    d.material({{"name", "plain"}, {"alphaMode", "MASK"}, {"alphaCutoff", 0.25}});
    d.first()["material"] = 0;
}

void wide_indices(Bar& d) {
    const std::vector<std::uint32_t> wide(d.arrays.indices.begin(), d.arrays.indices.end());
    d.first()["indices"] = d.add(wide, 5125, "SCALAR", 1);
}

}  // namespace

std::map<std::string, std::string> kept_samples() {
    const std::map<std::string, Change> changes{
        {"plain", [](Bar&) {}},
        {"hierarchy", hierarchy},
        {"skin", [](Bar& d) { d.add_skin(); }},
        {"skin_animated", [](Bar& d) { d.add_skin(), d.bend_knee(); }},
        {"skin_bytes", [](Bar& d) { whole_weights(d), d.bend_knee(); }},
        {"skin_two_sets", [](Bar& d) { two_skin_sets(d), d.bend_knee(); }},
        {"skin_morphed", [](Bar& d) { d.add_skin(), d.add_targets(), d.bend_knee(); }},
        {"morph", [](Bar& d) { d.add_targets(); }},
        {"morph_animated", morph_animation},
        {"morph_sparse", sparse_targets},
        {"cubic", cubic_animation},
        {"steps",
         [](Bar& d) {
             d.add_animation(0, "scale", {1, 1, 1, 2, 1, 1, 1, 3, 1}, 3, "STEP");
         }},
        {"two_materials", two_materials},
        {"two_materials_skin", [](Bar& d) { d.add_skin(), two_materials(d), d.bend_knee(); }},
        {"two_meshes", [](Bar& d) { d.add_second_mesh("second"); }},
        {"neighbour", textured_neighbour},
        {"instances", instances},
        {"gpu_instances", gpu_instances},
        {"cameras", cameras},
        {"lights", lights},
        {"extras", extras},
        {"unknown_extension", unknown_extension},
        {"variants", variants},
        {"sparse", sparse_positions},
        {"interleaved", interleave},
        {"quantised", quantise},
        {"strips", strips},
        {"fan", fans},
        {"unindexed", unindexed},
        {"flat", [](Bar& d) { d.attributes().erase("NORMAL"); }},
        {"bare", [](Bar& d) { d.attributes().erase("TEXCOORD_0"); }},
        {"attributes", more_attributes},
        {"byte_colors", byte_colors},
        {"second_scene", second_scene},
        {"lines", lines_beside},
        {"lone_image", lone_image},
        {"wide_indices", wide_indices}};
    std::map<std::string, std::string> samples;
    for (const auto& [name, change] : changes) {
        Bar draft;
        change(draft);
        samples[name] = draft.text();
    }
    return samples;
}

}  // namespace burl
