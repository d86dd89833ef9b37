// `burl metrics`: how well an atlas uses its texture, in the papers' measures, for our atlases and
// for the texture coordinates a file brings.
#include <bit>

#include <fmt/format.h>

#include "app/command_options.h"
#include "app/metrics_report.h"
#include "app/verbs.h"
#include "atlas/error.h"
#include "atlas/uv_atlas.h"

namespace burl {

namespace {

struct MetricsCommand {
    std::string mesh;
    RecipeOptions recipe;
    MeshOptions meshes;
    bool uv = false;
    bool json = false;
};

/// What is measured: the mesh, and one atlas after another.
class Measuring {
  public:
    Measuring(const MetricsCommand& command, Recipe recipe)
        : recipe_(std::move(recipe)),
          pipeline_(command.meshes.load(command.mesh)),
          edges_(mesh_edges(mesh(), pipeline_.connectivity())) {}

    const Mesh& mesh() const { return pipeline_.mesh(); }
    const Connectivity& connectivity() { return pipeline_.connectivity(); }

    MeasuredAtlas our_atlas(AtlasKind kind) {
        recipe_.atlas.kind = kind;
        pipeline_.set_recipe(recipe_);
        return measured(std::string(to_string(kind)), pipeline_.atlas(),
                        rasterize(mesh(), pipeline_.atlas(), mesh().positions));
    }

    MeasuredAtlas uv_atlas() {
        const Atlas atlas = atlas_from_uvs(mesh(), connectivity(), recipe_.atlas.size);
        return measured("uv", atlas, rasterize_uvs(mesh(), atlas, mesh().positions));
    }

  private:
    MeasuredAtlas measured(std::string name, const Atlas& atlas, const SolidAtlas& solid) {
        return {std::move(name), atlas, measure_atlas(mesh(), atlas, solid, edges_)};
    }

    Recipe recipe_;
    Pipeline pipeline_;
    std::vector<MeshEdge> edges_;
};

std::vector<AtlasKind> kinds_asked(const MetricsCommand& command, const Recipe& recipe) {
    if (command.recipe.kind != "all") return {recipe.atlas.kind};
    std::vector<AtlasKind> kinds{AtlasKind::uniform, AtlasKind::area, AtlasKind::length};
    if (std::has_single_bit(recipe.atlas.size)) {
        kinds.push_back(AtlasKind::quad);
    } else {
        fmt::print(stderr, "quad is left out: its size must be a power of two\n");
    }
    return kinds;
}

std::vector<MeasuredAtlas> measure_asked(const MetricsCommand& command, const Recipe& recipe,
                                         Measuring& measuring) {
    const bool has_uvs = !measuring.mesh().corners.uvs.empty(),
               asked = command.recipe.kind.has_value();
    if (command.uv && !has_uvs)
        throw Error(ExitCode::usage,
                    fmt::format("{} has no texture coordinates: leave out --uv to measure an atlas "
                                "of ours",
                                command.mesh));
    const bool measure_uvs = command.uv || (has_uvs && !asked);
    std::vector<MeasuredAtlas> result;
    if (measure_uvs) result.push_back(measuring.uv_atlas());
    if (asked || !measure_uvs)
        for (const AtlasKind kind : kinds_asked(command, recipe))
            result.push_back(measuring.our_atlas(kind));
    return result;
}

void run_metrics(const MetricsCommand& command) {
    RecipeOptions options = command.recipe;
    if (options.kind == "all") options.kind.reset();
    const Recipe recipe = options.load();
    Measuring measuring(command, recipe);
    const std::vector<MeasuredAtlas> atlases = measure_asked(command, recipe, measuring);
    if (command.json) {
        Json rows = Json::array();
        for (const MeasuredAtlas& atlas : atlases) rows.push_back(measured_json(atlas));
        write_json("-", {{"mesh", mesh_json(measuring.mesh(), measuring.connectivity())},
                         {"atlases", rows}});
        return;
    }
    fmt::print("{} triangles, {} without area\n", measuring.mesh().triangles.size(),
               measuring.mesh().notes.degenerate_triangles);
    print_measures(atlases);
}

}  // namespace

void add_metrics(CLI::App& program) {
    auto* verb = program.add_subcommand(
        "metrics", "Measure an atlas, or the texture coordinates a file brings");
    auto command = std::make_shared<MetricsCommand>();
    verb->add_option("mesh", command->mesh, "Mesh file: .obj .ply .stl .off .gltf .glb")
        ->required();
    command->recipe.add_recipe(*verb);
    command->recipe.add_atlas(*verb);
    verb->get_option("--atlas")->description("Atlas: uniform, area, length, quad, or all");
    verb->add_flag("--uv", command->uv,
                   "Measure the file's own texture coordinates (the default for a file that has "
                   "them when no --atlas is asked)");
    command->meshes.add(*verb);
    verb->add_flag("--json", command->json, "Print JSON");
    verb->callback([command] { run_metrics(*command); });
}

}  // namespace burl
