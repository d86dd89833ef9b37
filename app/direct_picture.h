#pragma once
// What `burl render --direct` is asked for, from its options to the picture, so that the figures
// (app/figures.h) are drawn from the very command lines a user would type.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command_options.h"
#include "app/direct_render.h"
#include "atlas/mesh_pose.h"

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
    std::string pose;  ///< app/load_pose.h; empty: none
    double crease = 40.0;

    void add(CLI::App& verb);
    View parsed_view() const;
    /// `picture` with --size and --unlit.
    PictureOptions picture_options() const;
};

/// A mesh and planes that were read once, for any number of pictures (frames).
class DirectPicture {
  public:
    /// Throws Error: usage for options that do not fit together, else as reading does.
    explicit DirectPicture(const DirectOptions& options);

    /// `recipe`: what the mesh shows, and the planes that name none. Throws Error(unsupported) as
    /// check_lattice does.
    Image<Rgb8> operator()(const Recipe& recipe) const;

    /// Files that the planes' recipes were read from.
    const std::vector<std::string>& plane_files() const { return plane_files_; }

  private:
    struct PlacedPlane {
        Plane plane;
        std::optional<Recipe> recipe;
    };
    FilteredColor color_of(const Recipe& recipe, FilterKind otherwise) const;
    std::vector<PlaneLayer> layers(const Recipe& recipe) const;
    Image<Rgb8> draw_posed(const Recipe& recipe, const std::vector<PlaneLayer>& planes) const;

    PictureOptions picture_;
    std::optional<FilterKind> filter_;
    bool widths_;
    Mesh mesh_;
    std::vector<Vec3f> normals_, posed_normals_;
    std::optional<MeshPose> pose_;
    std::vector<PlacedPlane> planes_;
    std::vector<std::string> plane_files_;
    Camera camera_;
};

}  // namespace burl
