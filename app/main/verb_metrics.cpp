// `burl metrics`: the quality of an atlas by the papers' measures, for Burl's atlases and for a
// file's own texture coordinates.
#include <array>
#include <bit>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/base/messages.h"
#include "app/export/command_files.h"
#include "app/image/image_io.h"
#include "app/main/verbs.h"
#include "app/measure/metric_texture.h"
#include "app/measure/metrics_pictures.h"
#include "app/measure/metrics_report.h"
#include "app/options/command_options.h"
#include "app/options/idle_options.h"
#include "app/options/metres.h"
#include "app/recipe/parameters.h"
#include "atlas/base/error.h"
#include "atlas/measure/surface_points.h"
#include "atlas/measure/uv_atlas.h"

namespace burl {

namespace {

struct MetricsCommand {
    std::string mesh;
    std::string texture, fill = "extrapolate";
    RecipeOptions recipe;
    MeshOptions meshes;
    std::string image;  // prefix of pictures; empty: none
    std::optional<std::string> view;
    bool uv = false, levels = false, json = false;
};

/// The way to fill gaps, by the name that --fill takes.
GapFill gap_fill(const std::string& name) {
    if (name == "black") return GapFill::black;
    return name == "nearest" ? GapFill::nearest : GapFill::extrapolate;
}

/// The pictures that are drawn of each atlas.
constexpr std::array picture_topics{"charts", "scale", "levels"};

std::string picture_path(const std::string& prefix, std::string_view atlas, const char* topic) {
    return fmt::format("{}-{}-{}.png", prefix, atlas, topic);
}

/// The name of our atlas of a kind; "uv" names the file's own coordinates as the file has them.
std::string name_of(AtlasKind kind) {
    return kind == AtlasKind::uv ? "uv-atlas" : std::string(to_string(kind));
}

/// Loads the mesh. Throws Error(usage) where --uv asks for texture coordinates that it does not
/// have.
Mesh load_measured(const MetricsCommand& command) {
    Mesh mesh = command.meshes.load(command.mesh);
    if (command.uv && mesh.corners.uvs.empty())
        throw Error(ExitCode::usage,
                    fmt::format("{} has no texture coordinates: leave out --uv to measure an atlas "
                                "of ours",
                                command.mesh));
    return mesh;
}

/// The measurement of one atlas after another on a mesh.
class Measuring {
  public:
    Measuring(const MetricsCommand& command, Recipe recipe, Mesh measured_mesh)
        : recipe_(std::move(recipe)),
          pipeline_(std::move(measured_mesh)),
          edges_(mesh_edges(mesh(), pipeline_.connectivity())),
          texture_(command.texture == metric_marble_name ? metric_marble_texture()
                                                         : recipe_texture(recipe_, mesh())),
          fill_(gap_fill(command.fill)),
          image_(command.image),
          view_(command.view ? parse_view(*command.view) : View{}) {
        if (!command.levels) return;
        TruthOptions options;
        options.size = recipe_.atlas.size;
        options.detail = texture_.detail;
        truth_ = surface_truth(normalised(mesh()), texture_.color, options);
    }

    const Mesh& mesh() const { return pipeline_.mesh(); }
    const Connectivity& connectivity() { return pipeline_.connectivity(); }

    MeasuredAtlas our_atlas(AtlasKind kind) {
        recipe_.atlas.kind = kind;
        pipeline_.set_recipe(recipe_);
        const MeshAtlas& atlas = pipeline_.mesh_atlas();
        const auto points_of = [&](const Mesh& surface, const Atlas&, const auto& positions) {
            return rasterize(surface, atlas, positions);
        };
        const std::string name = name_of(kind);
        if (!atlas.patches())
            return with_direct(measured(name, mesh(), edges_, atlas.atlas(), truth_, points_of),
                               truth_);
        const Mesh& refined = pipeline_.atlas_mesh();
        const std::optional<SurfaceTruth> truth = refined_truth(atlas);
        return with_direct(measured(name, refined, mesh_edges(refined, build_connectivity(refined)),
                                    atlas.atlas(), truth, points_of),
                           truth);
    }

    MeasuredAtlas uv_atlas() {
        return measured("uv", mesh(), edges_,
                        atlas_from_uvs(mesh(), connectivity(), recipe_.atlas.size), truth_,
                        rasterize_uvs);
    }

  private:
    /// Adds the errors of levels synthesised directly, which only a recipe's texture has.
    MeasuredAtlas with_direct(MeasuredAtlas result, const std::optional<SurfaceTruth>& truth) {
        if (!truth || texture_.name == metric_marble_name) return result;
        const Image<RgbF> texture = pipeline_.synthesize<RgbF>();
        const auto count = std::uint32_t(truth->levels.size());
        result.direct = level_errors(pipeline_.atlas(),
                                     pipeline_.levels(texture, count, {.direct = true}), *truth);
        return result;
    }

    std::optional<SurfaceTruth> refined_truth(const MeshAtlas& atlas) const {
        std::optional<SurfaceTruth> truth = truth_;
        if (!truth) return truth;
        truth->points = refined_points(mesh(), atlas, std::move(truth->points));
        truth->level_points = refined_points(mesh(), atlas, std::move(truth->level_points));
        truth->grazing.points = refined_points(mesh(), atlas, std::move(truth->grazing.points));
        return truth;
    }

    /// Measures an atlas; `surface` is the mesh whose triangles the atlas places, and the truth's
    /// points lie on it.
    template <class Rasterize>
    MeasuredAtlas measured(std::string name, const Mesh& surface,
                           const std::vector<MeshEdge>& edges, const Atlas& atlas,
                           const std::optional<SurfaceTruth>& truth, Rasterize&& points_of) const {
        const SolidAtlas solid = points_of(surface, atlas, surface.positions);
        MeasuredAtlas result{
            std::move(name), atlas,        measure_atlas(surface, atlas, solid, edges),
            texture_.name,   std::nullopt, {}};
        if (!truth && image_.empty()) return result;
        const Mesh unit = normalised(surface);
        const TextureValues values =
            fill_texture(points_of(unit, atlas, unit.positions), texture_.color, fill_);
        if (truth)
            result.lookups = measure_lookups(unit, atlas, values, edges, *truth, in_8bit_srgb());
        if (!image_.empty())
            draw({surface, atlas, solid, view_}, measure_charts(surface, atlas, edges), values,
                 result);
        return result;
    }

    void draw(const PicturedAtlas& what, const ChartMetrics& charts, const TextureValues& values,
              MeasuredAtlas& measured) const {
        const auto write = [&](const char* topic, const Image<Rgb8>& picture) {
            measured.images.push_back(picture_path(image_, measured.name, topic));
            write_png(measured.images.back(), picture);
        };
        write(picture_topics[0], charts_picture(what, charts.of_triangle));
        write(picture_topics[1], scale_picture(what));
        write(picture_topics[2], levels_picture(what, values));
    }

    Recipe recipe_;
    Pipeline pipeline_;
    std::vector<MeshEdge> edges_;
    MetricTexture texture_;
    GapFill fill_;
    std::string image_;
    View view_;
    std::optional<SurfaceTruth> truth_;
};

std::vector<AtlasKind> kinds_asked(const MetricsCommand& command, const Recipe& recipe) {
    if (command.recipe.given("atlas.kind") != "all") return {recipe.atlas.kind};
    std::vector<AtlasKind> kinds{AtlasKind::uniform, AtlasKind::area, AtlasKind::length};
    if (std::has_single_bit(recipe.atlas.size)) {
        kinds.push_back(AtlasKind::quad);
    } else {
        warn("quad is left out: its size must be a power of two");
    }
    kinds.push_back(AtlasKind::patch);
    return kinds;
}

/// Throws Error(io) where a picture would replace a file that is read, or cannot be written.
void check_pictures(const MetricsCommand& command, const Recipe& recipe, bool uvs,
                    const std::vector<AtlasKind>& kinds) {
    if (command.image.empty()) return;
    CommandFiles files;
    files.read(files_of_mesh(command.mesh));
    files.read(files_of_recipe(command.recipe.recipe, recipe));
    for (const char* topic : picture_topics) {
        if (uvs) files.write(picture_path(command.image, "uv", topic));
        for (const AtlasKind kind : kinds)
            files.write(picture_path(command.image, name_of(kind), topic));
    }
}

/// Throws Error(usage) for edits without effect; edits of the texture have one only where it is
/// looked up.
void check_recipe(const MetricsCommand& command, const RecipeOptions& options,
                  const Recipe& recipe) {
    const bool looked_up =
        (command.levels || !command.image.empty()) && command.texture == "recipe";
    const char* const why = looked_up ? "metrics looks up the texture alone"
                                      : "metrics looks up no texture of the recipe; add --levels "
                                        "and --texture recipe";
    std::vector<IdleKey> keys{{"bump", why}, {"filter", why}, {"paint", why}, {"pose", why}};
    if (!looked_up)
        for (const char* key : {"solid", "texture", "precision"}) keys.push_back({key, why});
    refuse_edits(options, keys);
    if (options.time && !looked_up)
        throw Error(ExitCode::usage, fmt::format("--time does nothing: {}; leave it out", why));
    if (command.recipe.given("atlas.kind") != "all") check_edits(options, recipe);
}

/// Throws Error(usage) for options of Burl's atlases where only the file's own texture coordinates
/// are measured.
void check_uv_options(const MetricsCommand& command) {
    for (const RecipeEdit& edit : command.recipe.edits())
        if (edit.path.starts_with("atlas.") && edit.path != "atlas.size")
            throw Error(ExitCode::usage,
                        fmt::format("{} is of our atlases, and {}'s own texture coordinates are "
                                    "measured; add --atlas, or leave it out",
                                    edit.said, command.mesh));
}

/// The atlases to measure.
struct AtlasesAsked {
    bool uvs = false;  ///< the file's own texture coordinates
    std::vector<AtlasKind> kinds;
};

/// The atlases that the options ask for. Throws Error for options that do not fit them, and for
/// their pictures' paths.
AtlasesAsked atlases_asked(const MetricsCommand& command, const Recipe& recipe, const Mesh& mesh) {
    const bool has_uvs = !mesh.corners.uvs.empty(),
               asked = command.recipe.given("atlas.kind").has_value();
    AtlasesAsked result{command.uv || (has_uvs && !asked), {}};
    if (result.uvs && !asked) check_uv_options(command);
    if (asked || !result.uvs) result.kinds = kinds_asked(command, recipe);
    check_pictures(command, recipe, result.uvs, result.kinds);
    return result;
}

void run_metrics(const MetricsCommand& command) {
    RecipeOptions options = command.recipe;
    if (options.given("atlas.kind") == "all")
        std::erase_if(options.parameters, [](const ParameterOption& option) {
            return option.parameter->path == "atlas.kind";
        });
    Recipe recipe = options.load();
    check_recipe(command, options, recipe);
    if (recipe.atlas.columns() != recipe.atlas.rows())
        throw Error(
            ExitCode::unsupported,
            fmt::format("metrics measures square textures; use --size {}", recipe.atlas.size));
    Mesh mesh = load_measured(command);
    set_metres({&recipe, 1}, options, command.meshes.frame, mesh);
    const AtlasesAsked asked = atlases_asked(command, recipe, mesh);
    Measuring measuring(command, recipe, std::move(mesh));
    std::vector<MeasuredAtlas> atlases;
    if (asked.uvs) atlases.push_back(measuring.uv_atlas());
    for (const AtlasKind kind : asked.kinds) atlases.push_back(measuring.our_atlas(kind));
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
    command->recipe.add_parameters(*verb);
    verb->get_option("--atlas")->description(
        fmt::format("Atlas: {}, or all", fmt::join(enum_names<AtlasKind>, ", ")));
    verb->add_flag("--uv", command->uv,
                   "Measure the file's own texture coordinates (the default for a file that has "
                   "them when no --atlas is asked)");
    command->meshes.add(*verb);
    command->meshes.add_uv_set(*verb);
    verb->add_flag("--levels", command->levels,
                   "Also measure lookups: error per MIP level, seams, bleeding");
    auto* texture =
        verb->add_option("--texture", command->texture,
                         "What is looked up: metric-marble, or the recipe's texture (default: the "
                         "recipe's if --recipe is given)");
    texture->check(one_of({metric_marble_name, "recipe"}));
    verb->add_option("--fill", command->fill,
                     "Texels that show no triangle: extrapolate (the surface goes on for two "
                     "texels), nearest (copied) or black")
        ->check(one_of({"extrapolate", "nearest", "black"}))
        ->capture_default_str();
    verb->add_option("--image", command->image,
                     "Draw PREFIX-ATLAS-charts.png, -scale.png and -levels.png");
    verb->add_option("--view", command->view,
                     "Where --image looks from: AZ,EL,DIST as in burl render (default 30,20,3.5)");
    verb->add_flag("--json", command->json, "Print JSON");
    verb->get_option("--view")->needs("--image");
    verb->callback([command, verb, texture] {
        for (const char* option : {"--texture", "--fill"})
            if (verb->count(option) > 0 && !command->levels && command->image.empty())
                throw Error(ExitCode::usage,
                            fmt::format("{} is about lookups; add --levels or --image, or leave it "
                                        "out",
                                        option));
        if (texture->count() == 0)
            command->texture =
                verb->get_option("--recipe")->count() > 0 ? "recipe" : metric_marble_name;
        run_metrics(*command);
    });
}

}  // namespace burl
