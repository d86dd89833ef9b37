#pragma once
// The representations behind the library's values.
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/export/export.h"
#include "app/library/bake.h"
#include "app/pipeline/material.h"

namespace burl::library {

/// The numbers of an array of points or of numbers of points, one after the other.
template <class Number, class Row>
std::span<const Number> numbers_of(const std::vector<Row>& rows) {
    static_assert(sizeof(Row) % sizeof(Number) == 0);
    return {reinterpret_cast<const Number*>(rows.data()),
            rows.size() * (sizeof(Row) / sizeof(Number))};
}

struct Mesh::State {
    burl::Mesh mesh;
    std::string path;                 ///< its file, or the sample's name; empty: made of arrays
    std::vector<std::string> losses;  ///< what of a glTF's document the mesh alone does not hold
};

struct Recipe::State {
    burl::Recipe recipe;
    std::string origin;  ///< the file that paths of images are relative to
    std::vector<std::string> notes;
};

/// A picture in floats: a number, a colour, or a colour with alpha.
using FloatPicture = std::variant<Image<float>, Image<RgbF>, Image<RgbaF>>;

/// A picture in floats with its levels, the first of which is the picture.
struct FloatLevels {
    std::string name;
    std::vector<FloatPicture> levels;
};

/// The views of an image's levels.
struct NamedViews {
    std::string name;
    std::vector<ImageView> levels;
};

struct Baked::State {
    burl::Mesh mesh;            ///< the mesh that the atlas places
    Atlas atlas{};              ///< where its triangles lie
    std::vector<double> uvs{};  ///< two per corner
    int depth = 8;              ///< bits of a component
    Packing packing = Packing::gltf;
    BakedImage color{};                 ///< of 8 and 16 bits
    ExportOptions options{};            ///< its levels, and the other pictures of 8 and 16 bits
    std::vector<FloatLevels> floats{};  ///< of 32 bits
    std::vector<std::pair<std::string, PictureImage>> masks{};
    std::vector<NamedViews> views{};  ///< of all of these
    std::vector<std::pair<std::string, double>> factors{};
    std::vector<std::string> notes{};
    std::string mesh_path;                    ///< as of Mesh::State
    std::vector<std::string> mesh_losses{};   ///< as of Mesh::State
    std::vector<std::string> recipe_files{};  ///< the recipe's own file and its images
    burl::Recipe recipe{};                    ///< what it was made from, with its atlas's options
};

/// Fills in the views of all images.
void add_views(Baked::State& state);

}  // namespace burl::library
