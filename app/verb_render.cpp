// `burl render`: a picture of a textured scene through OpenGL, or of the texture itself in float64
// (--direct).
#include <array>
#include <optional>

#include <fmt/format.h>

#include "app/animation.h"
#include "app/command_options.h"
#include "app/direct_render.h"
#include "app/export.h"
#include "app/gl_context.h"
#include "app/gl_render.h"
#include "app/image_io.h"
#include "app/scene.h"
#include "app/verbs.h"

namespace burl {

namespace {

struct RenderCommand {
    std::string input, out, filter;
    std::optional<std::string> view, size;
    RecipeOptions recipe;
    AnimationOptions animation;
    MeshOptions meshes;
    PictureOptions picture;
    double crease = 40.0;
    bool direct = false, unlit = false;
};

Image<Rgb8> draw_scene(const RenderCommand& command, const View& view) {
    const Scene scene = load_scene(command.input);
    for (const std::string& note : scene.notes) warn(note);
    check_side_output(command.out, ".png", scene.files);
    const Camera camera = orbit_camera(view, bounding_sphere(scene), command.picture.size);
    std::optional<TextureFilter> filter;
    if (command.filter == "nearest") filter = TextureFilter::nearest;
    if (command.filter == "linear") filter = TextureFilter::linear;
    if (command.filter == "mip") filter = TextureFilter::mip;
    const std::unique_ptr<GlContext> context = create_osmesa_context();
    return render_scene(*context, scene, camera, command.picture, filter);
}

/// One picture, or one per frame.
void draw_truth(const RenderCommand& command, const View& view,
                const std::vector<std::string>& paths) {
    const std::vector<Recipe> recipes = frame_recipes(command.recipe, command.animation);
    const Mesh mesh = command.meshes.load(command.input);
    const Camera camera = orbit_camera(view, bounding_sphere(mesh), command.picture.size);
    for (std::size_t i = 0; i < paths.size(); ++i)
        write_png(paths[i],
                  render_direct(mesh, recipes[i], camera, command.picture, command.crease));
}

void run_render(RenderCommand command) {
    const std::vector<std::string> paths = frame_paths(command.out, command.animation);
    for (const std::string& path : paths)
        check_side_output(path, ".png", std::array{command.input, command.recipe.recipe});
    const View view = command.view ? parse_view(*command.view) : View{};
    if (command.size) command.picture.size = parse_picture_size(*command.size);
    command.picture.lit = !command.unlit;
    if (command.direct) return draw_truth(command, view, paths);
    write_png(command.out, draw_scene(command, view));
}

}  // namespace

void add_render(CLI::App& program) {
    auto* verb =
        program.add_subcommand("render", "Picture of a textured scene, or of the exact texture");
    auto command = std::make_shared<RenderCommand>();
    verb->add_option("scene", command->input, "Scene (.glb .gltf .obj), or any mesh with --direct")
        ->required();
    verb->add_option("-o,--output", command->out, "Picture to write (.png)")->required();
    verb->add_option("--size", command->size, "Picture size in pixels, WxH (default 1024x768)");
    verb->add_option(
        "--view", command->view,
        "Azimuth and elevation in degrees, distance in radii: AZ,EL,DIST (default 30,20,3.5)");
    auto* filter =
        verb->add_option("--filter", command->filter,
                         "Texture lookup: nearest, linear or mip (default: as the scene says)");
    filter->check(CLI::IsMember({"nearest", "linear", "mip"}));
    verb->add_flag("--unlit", command->unlit, "Show the texture's colours without light");
    verb->add_option("--supersample", command->picture.supersample, "n: n x n samples per pixel")
        ->check(CLI::Range(1, max_supersample))
        ->capture_default_str();
    auto* direct = verb->add_flag(
        "--direct", command->direct,
        "Evaluate the recipe's texture for every sample, in float64: the ground truth");
    direct->excludes(filter);
    command->recipe.add_recipe(*verb);
    command->recipe.add_precision(*verb, "float64");
    command->animation.add(*verb);
    for (const char* option : {"--recipe", "--set", "--precision", "--animate"})
        verb->get_option(option)->needs(direct);
    verb->add_option("--crease", command->crease,
                     "Angle in degrees above which computed normals split (--direct)")
        ->check(in_range(0.0, 180.0))
        ->capture_default_str();
    command->meshes.add(*verb);
    verb->callback([command] { run_render(*command); });
}

}  // namespace burl
