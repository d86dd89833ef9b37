#include "app/main/render_command.h"

#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/gl/device/context.h"
#include "app/recipe/recipe_names.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr const char* sheet_cell_size = "320x320";

/// Adds the options of what draws the picture.
void add_modes(CLI::App& verb, RenderCommand& command) {
    auto* direct = verb.add_flag(
        "--direct", command.direct,
        "Evaluate the recipe's texture for every sample, in float64: the ground truth");
    verb.add_option("--gl", command.platform,
                    "Draw with osmesa (software) or egl (a graphics processor)")
        ->capture_default_str()
        ->excludes(direct);
    auto* lazy = verb.add_flag("--lazy", command.lazy,
                               "Draw a mesh with the recipe's texture as if it had been baked; "
                               "only texels that the picture shows are worked out")
                     ->excludes(direct);
    verb.add_option("--report", command.report,
                    "Write what --lazy worked out as JSON to this file (- for stdout)")
        ->needs(lazy);
    verb.add_option("--level-rule", command.level_rule,
                    "How --lazy makes MIP levels, as burl bake does: average, direct or direct:N "
                    "(default direct)")
        ->needs(lazy);
    verb.add_option("--anisotropy", command.anisotropy,
                    "Lookups along the longer side of a pixel's footprint, at most, where MIP "
                    "levels are looked up, as the setting of engines")
        ->check(CLI::Range(1, 16))
        ->capture_default_str()
        ->excludes(direct)
        ->excludes(lazy);
    command.economy.add_skips(verb);
    verb.get_option("--no-skip")->needs(lazy);
    for (const char* option : {"--plane", "--widths", "--rays"})
        verb.get_option(option)->needs(direct);
}

/// Adds the options of pictures that follow one another, and of their file.
void add_frames(CLI::App& verb, RenderCommand& command) {
    command.animation.add(verb);
    auto* frames = verb.get_option("--frames");
    auto* turntable = verb.add_option("--turntable", command.turntable,
                                      "Frames of one turn of the camera round the object, a loop");
    turntable->check(CLI::Range(2, most_frames))
        ->excludes(frames)
        ->excludes(verb.get_option("--loop"));
    verb.get_option("--animate")->remove_needs(frames);
    verb.add_option("--fps", command.file.rate, "Frames per second of .webp, .gif and .apng")
        ->check(in_range(0.1, 100.0))
        ->capture_default_str();
    verb.add_option("--quality", command.file.quality,
                    "Quality of .webp: 0 to 99, or 100 for exactly the picture's colours")
        ->check(CLI::Range(0, lossless_quality))
        ->capture_default_str();
}

/// Adds the options of sheets.
void add_sheet(CLI::App& verb, RenderCommand& command) {
    auto* recipes =
        verb.add_option("--recipes", command.recipes,
                        "With --lazy or --direct: a sheet of pictures, one per recipe, each with "
                        "its name: names, .json files and patterns, as oak,*marble*");
    recipes->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->excludes(verb.get_option("--recipe"))
        ->excludes(verb.get_option("--plane"));
    verb.add_option("--columns", command.columns, "Pictures side by side on a sheet")
        ->check(CLI::Range(1, 100))
        ->needs(recipes);
}

/// Options that were given, for refusals of those that have no effect.
struct GivenOptions {
    const std::vector<std::string>& names;

    bool has(const std::string& option) const {
        return std::ranges::find(names, option) != names.end();
    }
    void refuse(const std::vector<std::string>& idle, const char* why) const {
        for (const std::string& option : idle)
            if (has(option)) throw Error(ExitCode::usage, fmt::format("{} {}", option, why));
    }
};

/// Throws Error(usage) for options of frames without frames, and of files that are not written.
void check_frames(const RenderCommand& command, const GivenOptions& given) {
    const bool moves = given.has("--frames") || given.has("--turntable");
    const PictureFormat format = picture_format(command.out);
    if (!moves) {
        given.refuse({"--animate"}, "needs --frames N, or --turntable N to turn the camera, too");
        given.refuse({"--fps"}, "is the speed of frames, and there is one picture; leave it out");
        if (format == PictureFormat::apng)
            throw Error(ExitCode::usage,
                        fmt::format("{}: an .apng is an animation, and there is one picture; ask "
                                    "for --turntable or --frames, or write a .png",
                                    command.out));
    }
    if (!holds_frames(format))
        given.refuse({"--fps"}, "is of .webp, .gif and .apng; numbered .png have no speed");
    if (format != PictureFormat::webp)
        given.refuse({"--quality"}, "is of .webp; no other picture has it");
}

/// Throws Error(usage) for options of planes and meshes that are not there.
void check_planes(const DirectOptions& options, const GivenOptions& given) {
    const bool bare = std::ranges::any_of(
        options.planes, [](const std::string& text) { return parse_plane(text).recipe.empty(); });
    if (!options.scene.empty() || options.planes.empty()) return;
    given.refuse(
        {"--crease", "--weld", "--unshare-instances", "--up", "--rotate", "--scale", "--units"},
        "is about a mesh, and there are planes alone; leave it out");
    if (!bare)
        given.refuse({"--recipe"},
                     "is shown nowhere: every plane names a recipe of its own; leave it out");
}

}  // namespace

void RenderCommand::add(CLI::App& verb) {
    platform = gl_platforms()[0];
    options.add(verb);
    verb.add_option("-o,--output", out,
                    "Picture to write (.png .webp .gif), or animation (.webp .gif .apng)")
        ->required();
    add_modes(verb, *this);
    add_frames(verb, *this);
    add_sheet(verb, *this);
    add_progress(verb, progress);
}

void RenderCommand::check(const std::vector<std::string>& names) const {
    const GivenOptions given{names};
    if (!direct && !lazy) {
        given.refuse({"--recipe", "--recipes", "--set", "--time", "--precision"},
                     "goes with --direct or --lazy: a scene that is drawn has its texture already");
        given.refuse({"--crease", "--weld", "--unshare-instances", "--material"},
                     "goes with --direct or --lazy: a scene is drawn as it is");
        given.refuse({"--scale", "--units"},
                     "goes with --direct or --lazy: the camera is as far from a scene as the scene "
                     "is large, so the picture is the same");
    }
    if (options.unlit || (options.light.light == "headlight" && !options.light.ground))
        given.refuse({"--rays"},
                     "is about an environment's light, which is not asked for; leave it out");
    if (options.unlit)
        given.refuse({"--crease"},
                     "is about light, and --unlit draws without; leave one of them out");
    if (options.widths)
        given.refuse({"--filter"},
                     "averages the colour, and --widths shows none; leave one of them out");
    if (lazy && options.filter && *options.filter != "mip")
        given.refuse({"--level-rule"}, "makes MIP levels, which only --filter mip looks up");
    check_frames(*this, given);
    check_planes(options, given);
}

void RenderCommand::complete() {
    camera = take_camera_moves(animation, turntable, options.parsed_view());
    if (options.view && camera.moves.size() == 3)
        throw Error(ExitCode::usage,
                    "--view does nothing: --animate moves all of the camera; leave it out");
    if (!direct && !lazy && !animation.keys.empty())
        throw Error(ExitCode::usage,
                    fmt::format("--animate {}: a scene that is drawn has its texture already, and "
                                "only camera.azimuth, camera.elevation and camera.distance can "
                                "move; use --lazy or --direct for recipes",
                                animation.keys.front()));
    if (!direct && !lazy && animation.asked() && camera.moves.empty())
        throw Error(ExitCode::usage,
                    "--frames: a scene that is drawn stands still; say how the camera moves, as "
                    "--animate camera.azimuth=0:360, or use --turntable");
    file.frames = std::max(1, animation.frames);
    check_rate(out, file);
    if (!is_sheet()) return;
    recipes = recipes_named(recipes);
    if (!options.size) options.size = sheet_cell_size;
}

DirectOptions RenderCommand::cell(std::size_t number) const {
    DirectOptions result = options;
    if (is_sheet()) result.recipe.recipe = recipes[number];
    return result;
}

std::vector<std::string> RenderCommand::paths() const {
    if (holds_frames(picture_format(out))) return {out};
    return frame_paths(out, animation);
}

}  // namespace burl
