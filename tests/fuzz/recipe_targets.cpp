// Recipes, settings of recipes, and MaterialX documents, and the textures of all of them.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "app/edit/node_graph.h"
#include "app/export/emit.h"
#include "app/materialx/materialx.h"
#include "app/pipeline/material.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/images.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/places.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/readers.h"
#include "tests/fuzz/target.h"
#include "tests/paths.h"

namespace burl::fuzz {
namespace {

/// The path of a file beside small pictures.
std::string path_of(const std::string& name) {
    return test::source_folder() + "/tests/fuzz/corpus/png/" + name;
}

constexpr std::string_view tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

Mesh small_mesh() {
    return build_mesh(parse_obj(buffer_from(tetrahedron, "a.obj")), "a.obj");
}

/// Whether a texture of 16 x 16 texels is a fair trial: what a person may ask for in a recipe and
/// must wait for is not.
bool is_small(const Recipe& recipe) {
    return recipe.filter.kind != FilterKind::supersample || recipe.filter.samples <= 4;
}

void fill(Recipe recipe) {
    recipe.atlas = AtlasOptions{.kind = AtlasKind::quad, .size = 16};
    const Mesh mesh = small_mesh();
    check_lattice(recipe, mesh);
    if (!is_small(recipe)) return;
    Pipeline pipeline(mesh);
    pipeline.set_threads(1);
    pipeline.set_recipe(recipe);
    pipeline.synthesize<Rgb8>();
    if (!recipe.bump.empty()) pipeline.normal_map<Rgb8>(40.0, false);
    std::vector<PicturePlan> plans{base_color_plan(recipe)};
    for (const MaterialPicture& picture : material_pictures(recipe, Packing::gltf))
        plans.push_back(picture.plan);
    if (recipe.precision.kind != PrecisionKind::fixed) pipeline.pictures<Rgba8>(plans);
}

/// The shader without the uniforms of controls, which take it a second.
void write_shader(Recipe recipe) {
    recipe.controls.clear();
    try {
        emit_glsl(recipe, {});
    } catch (const Error&) {
    }
}

void use(const Recipe& recipe) {
    const std::string text = to_json(recipe);
    const std::string again = to_json(parse_recipe(text, path_of("a.json")));
    require(again == text, "a recipe that is written and read is the same");
    node_graph(recipe);
    recipe_leaves(slider_json(recipe));
    control_states(Json::parse(text));
    with_images_for(with_absolute_images(recipe, path_of("a.json")), path_of("a.json"),
                    scratch_file("b.json", ""));
    for (int i = 0; i < std::min(2, frame_count(recipe.animation)); ++i)
        recipe_at(recipe, frame_seconds(recipe.animation, i, 2));
    write_shader(recipe);
    fill(recipe_at(recipe, 0.25));
}

void read_recipe(const std::string& bytes) {
    use(parse_recipe(bytes, path_of("a.json")));
}

/// A preset's name in the first line, and a setting in each line after it.
void read_settings(const std::string& bytes) {
    std::istringstream lines(bytes);
    std::string preset, line;
    std::getline(lines, preset);
    std::vector<std::string> settings;
    while (std::getline(lines, line)) settings.push_back(line);
    if (preset.find('/') == std::string::npos) use(load_recipe(preset, settings));
}

void read_materialx(const std::string& bytes) {
    const MaterialXRecipe made = recipe_of_materialx(bytes, path_of("a.mtlx"));
    use(parse_recipe(made.json, path_of("a.json")));
}

/// Each node that is read, in a document of its own.
std::vector<std::string> graphs() {
    std::ifstream file(test::source_folder() + "/tests/app/materialx/graphs.mtlx");
    const std::string all(std::istreambuf_iterator<char>(file), {});
    constexpr std::string_view end = "</surfacematerial>";
    std::vector<std::string> documents;
    for (std::size_t at = 0; (at = all.find("<nodegraph name", at)) != std::string::npos;) {
        const std::size_t count = all.find(end, at) + end.size() - at;
        documents.push_back("<materialx version=\"1.39\">" + all.substr(at, count) +
                            "</materialx>");
        at += count;
    }
    return documents;
}

}  // namespace

std::vector<Target> recipe_targets() {
    return {{"recipe",
             read_recipe,
             Form::json,
             {"assets/recipes/papers", "assets/materials", "tests/app/materialx/graphs.json",
              "tests/cases"},
             {"define", "controls", "animation", "paint", "bump", "filter", "precision", "fixed",
              "float64", "rgb.png", "palette.png"}},
            {"settings",
             read_settings,
             Form::text,
             {},
             {"marble",
              "wood",
              "oak",
              "texture.",
              "texture.input.",
              "input.noise.0.",
              "noise.9.",
              "colors.stops.0.",
              "amplitude=",
              "frequency=",
              "octaves=",
              "atlas.kind=",
              "filter=",
              "precision=",
              "material.",
              "roughness=",
              "bump.height=",
              "animation.seconds=",
              "define.",
              "=1e300",
              "=-1",
              "=0",
              "=null",
              "=true",
              "=[",
              "={}",
              "=\"#ff0000\"",
              "=[1,2,3]"}},
            {"materialx",
             read_materialx,
             Form::text,
             {"docs/images/serpentine.mtlx"},
             {"<input name=\"",
              " type=\"float\"",
              " value=\"",
              " nodename=\"",
              " nodegraph=\"",
              " output=\"",
              "/>",
              "color3",
              "vector2",
              "vector3",
              "vector4",
              "integer",
              "boolean",
              "<multiply ",
              "<mix ",
              "<image ",
              "<standard_surface ",
              "<surfacematerial ",
              "<nodedef ",
              "<!DOCTYPE",
              "&amp;",
              "<![CDATA[",
              "1e999",
              "-1",
              "interfacename=\"",
              "<nodegraph ",
              "</nodegraph>",
              "<xi:include href=\"a.mtlx\"/>"},
             32768,
             graphs}};
}

}  // namespace burl::fuzz
