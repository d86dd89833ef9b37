#pragma once
// Textures of a glTF file as those of a scene: images with their samplers and the MIP levels
// that Burl wrote beside them.
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/image/image_io.h"
#include "app/scene/scene.h"

namespace tinygltf {
class Model;
struct Texture;
}  // namespace tinygltf

namespace burl {

/// Loads textures of a file at their first use.
class GltfTextures {
  public:
    /// `model`, `path` and `textures`, to which the textures are added, must outlive the object;
    /// `path` is the file's, whose pictures may lie where `named` says.
    GltfTextures(const tinygltf::Model& model, const std::string& path, NamedFiles named,
                 std::vector<SceneTexture>& textures)
        : model_(model), path_(path), named_(named), textures_(textures) {}

    /// The index in the scene of glTF texture `number`, which must exist, as colour or as data.
    /// Throws Error: io for an image that is not there, and as decode_picture() does.
    int load(int number, bool is_color);
    /// Whether glTF texture `number` exists and its image is there, of a format that is read.
    bool has_picture(int number) const;

  private:
    int source_of(int number) const;
    PictureColors image(int number) const;
    void add_levels(SceneTexture& texture, const tinygltf::Texture& source) const;

    const tinygltf::Model& model_;
    const std::string& path_;
    NamedFiles named_;
    std::vector<SceneTexture>& textures_;
    /// Scene textures by glTF texture and use as colour.
    std::map<std::pair<int, bool>, int> loaded_;
};

}  // namespace burl
