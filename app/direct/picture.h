#pragma once
// `burl render --direct` from its options to the picture. The figures (app/direct/figures.h) are
// drawn from the same command lines.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/direct/render.h"
#include "app/options/animation.h"
#include "app/options/command_options.h"
#include "app/options/light.h"
#include "atlas/read/pose.h"

namespace burl {

/// A plane and the recipe it shows; an empty name means the recipe of --recipe.
struct PlaneArgument {
    Plane plane;
    std::string recipe;
};

/// Parses "RECIPE:NX,NY,NZ,D" or "NX,NY,NZ,D", for example "clouds:0,1,0,4"; the plane's normal has
/// length 1. Throws Error(usage).
PlaneArgument parse_plane(const std::string& text);

/// Options of `burl render`. The scene, --view, --up, --rotate, --size, --filter, --unlit,
/// --supersample and the options of light apply to every picture; the others to --direct and,
/// except --plane and --widths, to --lazy.
struct DirectOptions {
    std::string scene;  ///< a mesh (file or "sample:NAME"); may be empty where there are planes
    std::optional<std::string> view, size, filter;
    PictureOptions picture;
    LightArguments light;
    bool unlit = false;

    std::vector<std::string> planes;
    bool widths = false;
    RecipeOptions recipe;
    MeshOptions meshes;
    std::string pose;  ///< --pose (app/surface/sample_meshes.h); empty: none
    /// Directions that each sample's light is summed over with --direct; 0: none, and no shadows.
    int rays = 96;
    double crease = 40.0;

    void add(CLI::App& verb);
    /// The value of --view, or the default view. Throws Error(usage).
    View parsed_view() const;
    /// The options `picture` with --size, --unlit and those of light applied. Throws Error(usage).
    PictureOptions picture_options() const;
};

/// The recipes that one picture shows.
struct PictureRecipes {
    Recipe main;  ///< the recipe of --recipe: for the mesh, and for planes that name none
    std::vector<std::optional<Recipe>> planes;  ///< per plane its own recipe, if it names one
};

/// The recipes of every frame, or of a single picture without --frames. An edit (--set, --animate)
/// applies to the recipe of --recipe, or as NAME:PATH... to the shown recipe of that name; --time
/// applies to all. Throws Error, usage among others for edits without effect on the picture.
std::vector<PictureRecipes> picture_recipes(const DirectOptions& options,
                                            const AnimationOptions& animation);

/// A mesh and planes, loaded once for any number of pictures (frames).
class DirectPicture {
  public:
    /// Loads the mesh and its pose. `smooth`, where there is one, is taken for the environment's
    /// light, without shadows; the options must name an environment then. Throws Error: usage for
    /// options that do not fit together, else as load_pose and MeshOptions::load do.
    explicit DirectPicture(const DirectOptions& options,
                           std::shared_ptr<const PrefilteredLight> smooth = nullptr);

    /// Sets the view of the following pictures, at first that of --view.
    void look(const View& view) { camera_ = orbit_camera(view, sphere_, picture_.size); }

    /// The mesh at rest, in its frame; empty where there are planes alone.
    const Mesh& mesh() const { return mesh_; }

    /// Draws a picture. `recipes` are those of picture_recipes(), or the main one alone where no
    /// plane names any. Throws Error(unsupported) as check_lattice does, and for bumps of a mesh in
    /// a pose.
    Image<Rgb8> operator()(const PictureRecipes& recipes) const;
    /// Draws a picture as operator() does, with the alpha of a transparent background.
    Image<Rgba8> with_alpha(const PictureRecipes& recipes) const;

  private:
    /// A recipe's colour, and in an environment its whole material.
    struct Shown {
        FilteredColor color;
        PointMaterial material;
    };
    void make_light();
    Shown shown(const Recipe& recipe, FilterKind otherwise, const Affine3& map) const;
    std::vector<PlaneLayer> layers(const PictureRecipes& recipes) const;
    Image<Rgba8> draw_posed(const Recipe& recipe, const std::vector<PlaneLayer>& planes) const;
    Image<Rgba8> draw(DirectScene scene) const;

    PictureOptions picture_;
    std::optional<FilterKind> filter_;
    bool widths_;
    int rays_;
    std::optional<Environment> environment_, backdrop_;  ///< where they light and are seen
    std::shared_ptr<const PrefilteredLight> smooth_;     ///< lights instead, without rays
    Mesh mesh_;
    std::vector<Vec3f> normals_, posed_normals_;
    std::optional<MeshPose> pose_;
    std::vector<Plane> planes_;
    Sphere sphere_;
    Camera camera_;
};

}  // namespace burl
