#pragma once
// What `burl render --direct` is asked for, from its options to the picture, so that the figures
// (app/direct/figures.h) are drawn from the very command lines a user would type.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/direct/render.h"
#include "app/options/animation.h"
#include "app/options/command_options.h"
#include "atlas/read/pose.h"

namespace burl {

/// Options of `burl render`; all but the last group are also those of a picture without --direct.
struct DirectOptions {
    std::string scene;  ///< a mesh (file or "sample:NAME"); may be empty where there are planes
    std::optional<std::string> view, size, filter;
    PictureOptions picture;
    bool unlit = false;

    std::vector<std::string> planes;
    bool widths = false;
    RecipeOptions recipe;
    MeshOptions meshes;
    std::string pose;  ///< app/surface/load_pose.h; empty: none
    double crease = 40.0;

    void add(CLI::App& verb);
    View parsed_view() const;
    /// `picture` with --size and --unlit.
    PictureOptions picture_options() const;
};

/// The recipes that one picture shows.
struct PictureRecipes {
    Recipe main;  ///< that of --recipe: of the mesh, and of planes that name none
    std::vector<std::optional<Recipe>> planes;  ///< of those that name one, in the planes' order
};

/// The recipes of every frame, or of the one picture without --frames. An edit (--set, --animate)
/// is of --recipe, or as NAME:PATH... of the recipe that the picture shows by that name; --time is
/// of all. Throws Error, usage for what would change nothing in the picture.
std::vector<PictureRecipes> picture_recipes(const DirectOptions& options,
                                            const AnimationOptions& animation);

/// A mesh and planes that were read once, for any number of pictures (frames).
class DirectPicture {
  public:
    /// Throws Error: usage for options that do not fit together, else as reading does.
    explicit DirectPicture(const DirectOptions& options);

    /// `recipes`: of picture_recipes(), or the main one alone where no plane names any. Throws
    /// Error(unsupported) as check_lattice does.
    Image<Rgb8> operator()(const PictureRecipes& recipes) const;

  private:
    FilteredColor color_of(const Recipe& recipe, FilterKind otherwise) const;
    std::vector<PlaneLayer> layers(const PictureRecipes& recipes) const;
    Image<Rgb8> draw_posed(const Recipe& recipe, const std::vector<PlaneLayer>& planes) const;

    PictureOptions picture_;
    std::optional<FilterKind> filter_;
    bool widths_;
    Mesh mesh_;
    std::vector<Vec3f> normals_, posed_normals_;
    std::optional<MeshPose> pose_;
    std::vector<Plane> planes_;
    Camera camera_;
};

}  // namespace burl
