#pragma once
// The command of `burl bake` and its options, which are also those of an entry of `burl batch`.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "app/gl/device/context.h"
#include "app/options/animation.h"
#include "app/options/command_options.h"
#include "atlas/mesh/subdivide.h"

namespace CLI {
class App;
}

namespace burl {

class Course;

/// Values of the options of one bake.
struct BakeCommand {
    std::string mesh, out, report;
    std::string pose;  ///< pose of the mesh (app/surface/sample_meshes.h); empty: none
    RecipeOptions recipe;
    AnimationOptions animation;
    MeshOptions meshes;
    EconomyOptions economy;
    int threads = 0;
    std::optional<int> depth;      ///< bits per channel, 32 of an .exr only; none: 8
    std::optional<double> crease;  ///< crease angle in degrees; none: 40
    std::string levels, level_rule, normals, solid_map, emitted_glsl;
    std::vector<std::string> channels;  ///< names of mask_picture_names
    std::string picture_format;         ///< the text of coding_asked; empty: by the output
    std::string packing;                ///< a word of Packing; empty: by the output's extension
    std::string normal_y = "+";         ///< the side of a normal map's green: + up, - down
    std::string kernel = "auto";  ///< a name of kernel_names, forward_kernel or reference_kernel
    std::string synth = "host", platform{};   ///< platform is that of OpenGL; empty: the first
    std::string gl_precision, gl_randomizer;  ///< words of multipass_synth; empty: its defaults
    bool gl_equalize = false;
    std::optional<double> compress;
    bool vertex_colors = false;   ///< colours per point in place of the texture
    bool strips = false;          ///< triangle strips in place of triangles
    std::optional<int> displace;  ///< how often triangles are split before displacement
    /// Recipes for materials of a glTF, GLOB=RECIPE, the first that matches counts.
    std::vector<std::string> assigned;
    bool recipe_given = false;            ///< whether --recipe was
    std::string atlas_per = "scene";      ///< scene, recipe, mesh or material
    std::optional<std::uint32_t> uv_set;  ///< the set for the atlas's texture coordinates
    bool strict = false;                  ///< whether what an output cannot keep is an error
    bool udim = false;                    ///< whether each UDIM tile gets an image of its own
    bool json = false, quiet = false;     ///< print the JSON report, or nothing, on stdout
    bool makes_folders = false;           ///< whether folders of outputs may be missing yet
    bool force = false;                   ///< bake even if the outputs are up to date
    std::string progress = "auto";        ///< a word of progress_modes
    Course* told = nullptr;               ///< is told of the bake's progress; null: nobody is

    /// Bits of pictures that are no .exr.
    int bits() const { return std::min(depth.value_or(8), 16); }
    /// The mesh at rest, split as --displace says. Throws Error as MeshOptions::load and
    /// subdivided() do.
    Mesh load_mesh() const {
        return subdivided(meshes.load(mesh), displace.value_or(0), meshes.read.most_triangles);
    }
    /// Sentences about what the document of the recipe, which has been loaded, says and the recipe
    /// does not hold. Throws
    /// Error(unsupported) where there is such a thing and --strict was given.
    std::vector<std::string> recipe_losses() const;
    double crease_degrees() const { return crease.value_or(40.0); }
};

/// The --synth that evaluates the papers' passes over whole images.
inline constexpr const char* multipass_synth = "gl-multipass";
/// The --kernel that sums forward differences (app/pipeline/fill_texture.h); its textures differ
/// from those of the other kernels.
inline constexpr const char* forward_kernel = "forward";
/// The --kernel that means --precision float64.
inline constexpr const char* reference_kernel = "reference";

/// Adds the mesh, the output, and all options that the output's content depends on.
void add_bake_options(CLI::App& verb, BakeCommand& command);

/// Adds --json, --report and --quiet.
void add_report_options(CLI::App& verb, BakeCommand& command);

/// Throws Error(usage) if two of --json, --report and --quiet contradict each other.
void check_report_options(bool json, const std::string& report, bool quiet);

/// Adds the options that no output depends on: --threads, --no-skip, --force, --cache, --progress
/// and those of add_input_limits().
void add_run_options(CLI::App& verb, BakeCommand& command);

/// The options of add_bake_options that are not in the recipe, without the mesh and the output, as
/// JSON: each as it was given, else its default. Two commands with equal settings, recipes and file
/// contents make the same outputs. Different spellings of the path of --pose, --solid-map or
/// --emit-glsl are different settings.
Json bake_settings(const CLI::App& verb);

}  // namespace burl
