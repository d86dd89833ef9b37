// `burl metrics`: how well an atlas uses its texture, in the papers' measures.
#include <fmt/format.h>

#include "app/command_options.h"
#include "app/report.h"
#include "app/verbs.h"

namespace burl {

namespace {

struct MetricsCommand {
    std::string mesh;
    RecipeOptions recipe;
    MeshOptions meshes;
    bool json = false;
};

std::vector<AtlasKind> kinds_asked(const MetricsCommand& command, const Recipe& recipe) {
    if (command.recipe.kind == "all")
        return {AtlasKind::uniform, AtlasKind::area, AtlasKind::length};
    return {recipe.atlas.kind};
}

void print_row(const Atlas& atlas, const AtlasMetrics& m) {
    fmt::print("{:<8} {:<8} {:>6} {:>9.4f} {:>9.4f} {:>9.4f} {:>7.3f}/{:.3f}/{:.3f} {:>8} {:>9}\n",
               to_string(atlas.options.kind), to_string(atlas.options.overscan), atlas.options.size,
               m.coverage, m.texel_coverage, m.relative_scale, m.density[0], m.density[1],
               m.density[2], m.charts, atlas.notes.saved_texels);
}

void run_metrics(const MetricsCommand& command) {
    RecipeOptions options = command.recipe;
    if (options.kind == "all") options.kind.clear();
    Recipe recipe = options.load();
    Pipeline pipeline(command.meshes.load(command.mesh));
    Json rows = Json::array();
    if (!command.json) {
        fmt::print("{} triangles, {} without area\n", pipeline.mesh().triangles.size(),
                   pipeline.mesh().notes.degenerate_triangles);
        fmt::print("{:<8} {:<8} {:>6} {:>9} {:>9} {:>9} {:>19} {:>8} {:>9}\n", "atlas", "overscan",
                   "size", "coverage", "texels", "scale", "density 5/50/95 %", "charts", "saved");
    }
    for (const AtlasKind kind : kinds_asked(command, recipe)) {
        recipe.atlas.kind = kind;
        pipeline.set_recipe(recipe);
        const AtlasMetrics metrics = measure(pipeline.mesh(), pipeline.atlas(), pipeline.solid());
        if (command.json) {
            rows.push_back(metrics_json(pipeline.atlas(), metrics));
        } else {
            print_row(pipeline.atlas(), metrics);
        }
    }
    if (command.json) {
        write_json("-", {{"mesh", mesh_json(pipeline.mesh(), pipeline.connectivity())},
                         {"atlases", rows}});
    }
}

}  // namespace

void add_metrics(CLI::App& program) {
    auto* verb = program.add_subcommand("metrics",
                                        "Measure coverage, relative scale and density of atlases");
    auto command = std::make_shared<MetricsCommand>();
    verb->add_option("mesh", command->mesh, "Mesh file: .obj .ply .stl .off .gltf .glb")
        ->required();
    command->recipe.add_recipe(*verb);
    command->recipe.add_atlas(*verb);
    verb->get_option("--atlas")->description("Atlas: uniform, area, length, or all");
    command->meshes.add(*verb);
    verb->add_flag("--json", command->json, "Print JSON");
    verb->callback([command] { run_metrics(*command); });
}

}  // namespace burl
