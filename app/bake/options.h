#pragma once
// What `burl bake` is asked for, and the options that say so: those of every entry of a batch, too.
#include <optional>
#include <string>

#include "app/base/json_text.h"
#include "app/gl/device/context.h"
#include "app/options/animation.h"
#include "app/options/command_options.h"
#include "app/options/economy_options.h"
#include "app/options/multipass_options.h"

namespace CLI {
class App;
}

namespace burl {

struct BakeCommand {
    std::string mesh, out, report;
    std::string pose;  ///< app/surface/load_pose.h; empty: none
    RecipeOptions recipe;
    AnimationOptions animation;
    MeshOptions meshes;
    EconomyOptions economy;
    int threads = 0;
    std::optional<int> depth;      ///< left out: 8
    std::optional<double> crease;  ///< left out: 40
    std::string levels, level_rule, normals, solid_map, emitted_glsl, kernel = "auto";
    std::string synth = "host", platform{};  ///< of OpenGL; empty: the first
    MultipassCommand multipass;
    std::optional<double> compress;
    bool json = false, quiet = false;  ///< what is said on stdout
    bool force = false;                ///< made again where it is up to date

    int bits() const { return depth.value_or(8); }
    double crease_degrees() const { return crease.value_or(40.0); }
};

/// The mesh, the output, and all that says how the one becomes the other.
void add_bake_options(CLI::App& verb, BakeCommand& command);

/// --json, --report and --quiet.
void add_report_options(CLI::App& verb, BakeCommand& command);

/// Throws Error(usage) where two of these contradict each other.
void check_report_options(bool json, const std::string& report, bool quiet);

/// How a run goes, whatever it makes: --threads, --no-skip, --force and --cache.
void add_run_options(CLI::App& verb, BakeCommand& command);

/// The options of add_bake_options that are not in the recipe, but for the mesh and the output,
/// each as it was given or else its default. Two commands that agree in these, in their recipes and
/// in their files' content make the same outputs; two that spell the file of --pose, --solid-map or
/// --emit-glsl in different ways do not agree.
Json bake_settings(const CLI::App& verb);

}  // namespace burl
