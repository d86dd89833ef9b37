#pragma once
// A bake: a mesh and a recipe become an atlas and the pictures of the material.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/library/mesh.h"
#include "app/library/progress.h"
#include "app/library/recipe.h"

namespace burl::library {

/// The options of bake().
struct BakeOptions {
    /// Texels a side of the texture, 1 to 16384; 0: as the recipe says.
    std::uint32_t size = 0;
    /// Kind of atlas: "uniform", "area", "length", "quad", "patch", "chart" or "uv"; empty: as the
    /// recipe says.
    std::string atlas{};
    /// Bits of a component: 8 or 16 for codes, 32 for floats.
    int depth = 8;
    /// Number of MIP levels above level 0; -1: all, down to 1 x 1. Atlases of strips may have
    /// fewer, and with depth 32 any number but 0 means all.
    int levels = 0;
    /// Which channels share an image: "gltf" (occlusion, roughness and metallic in one, "orm"),
    /// "unreal", "unity", "godot", or "separate" (an image per channel). What does not vary is a
    /// factor.
    std::string packing = "gltf";
    /// Masks of the mesh's shape that are made besides, by the names of their nodes
    /// (docs/reference/masks.md), such as "occlusion" and "curvature"; not with depth 32.
    std::vector<std::string> masks{};
    /// Whether a recipe with bumps gives a normal map, in tangent space.
    bool normals = true;
    /// Angle in degrees, 0 to 180, of edges at and beyond which computed normals break.
    double crease = 40.0;
    /// Number of threads; 0: all. No result depends on it.
    int threads = 0;
    /// Is told how far the bake is; empty: nobody is.
    Progress progress{};
};

/// The type of an image's components.
enum class ComponentType {
    u8,   ///< 8-bit codes, 0 to 255
    u16,  ///< 16-bit codes, 0 to 65535
    f32   ///< floats, linear; colours with alpha are multiplied by it
};

/// An image: rows of pixels, row 0 first, each pixel its components one after the other, without
/// padding. Row 0 has v = 0.
struct ImageView {
    std::size_t width = 0;                   ///< pixels in a row
    std::size_t height = 0;                  ///< rows
    std::size_t components = 0;              ///< 1 (a number), 3 (RGB) or 4 (RGBA)
    ComponentType type = ComponentType::u8;  ///< type of each component
    bool srgb = false;           ///< whether red, green and blue are sRGB codes, else linear
    const void* data = nullptr;  ///< width * height * components values
};

/// The result of a bake, which does not change. Copies share the images. What is returned as span
/// or view is valid as long as a copy of the Baked is.
class BURL_API Baked {
  public:
    /// The points of the mesh that the atlas places, shape (points, 3), in mesh units; a patch
    /// atlas may have split triangles.
    std::span<const double> positions() const;
    /// The points of each triangle's corners, shape (triangles, 3).
    std::span<const std::uint32_t> triangles() const;
    /// Texture coordinates per corner, shape (triangles, 3, 2), 0 to 1, v = 0 at row 0.
    std::span<const double> uvs() const;
    /// The names of the images: "color" first, then what varies ("orm", "emissive", ...; see
    /// BakeOptions::packing), "normal" for a recipe with bumps, and the masks asked for.
    std::vector<std::string> image_names() const;
    /// The number of an image's levels, at least 1. Throws Error(usage) for an unknown name.
    std::size_t level_count(const std::string& name) const;
    /// An image, or level `level` of it. Throws Error(usage) for an unknown name, listing those
    /// there are, and for a level that there is not.
    ImageView image(const std::string& name, std::size_t level = 0) const;
    /// The material's numbers ("roughness", "metallic", ...), each 0 to 1: factors of what an image
    /// shows, 1 for channels that have one.
    std::vector<std::pair<std::string, double>> factors() const;
    /// Sentences on what the atlas could not do, such as triangles with too few texels.
    std::vector<std::string> notes() const;

    /// The library's own representation.
    struct State;
    /// The library's own representation.
    const State& state() const { return *state_; }
    /// Takes the library's own representation.
    explicit Baked(std::shared_ptr<const State> state);

  private:
    std::shared_ptr<const State> state_;
};

/// Bakes a mesh. Throws Error: usage for options out of range, for recipes that the options do not
/// fit and for texture coordinates that the atlas "uv" lacks; runtime where the texture cannot hold
/// the mesh; unsupported where the recipe's lattice is too fine for the mesh; stopped where the
/// callback says so, within about a tenth of a second but for stages that cannot be divided.
BURL_API Baked bake(const Mesh& mesh, const Recipe& recipe, const BakeOptions& options = {});

/// Writes the mesh with its images, or the images alone, by the path's extension: .glb, .gltf,
/// .obj, .mtlx, .ply, .stl, .png, .jpg, .webp, .ktx2, or .exr for a bake with depth 32. All files
/// are written or none is. The bytes are those of `burl bake` with the same options, but that it
/// keeps a glTF's document and an OBJ's polygons and materials, and this function the mesh alone.
/// glTF needs the packing "gltf". Returns sentences on what of the mesh's file and of the material
/// the output does not hold. Throws Error: usage for an extension that does not fit, io when a
/// write fails and for a file that the mesh or the recipe was read from, which stays as it is.
BURL_API std::vector<std::string> write(const Baked& baked, const std::string& path);

}  // namespace burl::library
