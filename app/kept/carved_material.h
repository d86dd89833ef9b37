#pragma once
// The material of a carved mesh in the document that it goes back to: it takes the place of the old
// one where nothing else has that.
#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/export/formats.h"
#include "app/kept/document.h"

namespace burl {

/// A carved mesh's textures in a document, and the materials that show them.
class CarvedMaterial {
  public:
    /// Adds the textures of the content to the document; `pictures` is that of CarvedMesh. The
    /// arguments must outlive the object.
    CarvedMaterial(KeptDocument& document, const SceneContent& content,
                   const std::string& pictures);

    /// Notes that the primitive (mesh, primitive) is to have the material, with its texture
    /// coordinates in the set `uv_set`; `share` is the number of its recipe among those that share
    /// the atlas.
    void use_at(std::array<std::size_t, 2> primitive, std::uint32_t uv_set, std::uint32_t share);
    /// Gives the noted primitives their materials: one for each old material and set of texture
    /// coordinates, with the old one's name, sides and extras.
    void assign();

    /// The files of pictures beside a .gltf.
    std::vector<AtomicFile> take_files() { return std::move(files_); }

  private:
    struct Key {
        int material = -1;  ///< the old one; -1: none
        std::uint32_t uv_set = 0, share = 0;
        auto operator<=>(const Key&) const = default;
    };

    void add_image(const SceneImage& image);
    std::size_t add_sampler();
    std::set<int> used_materials() const;
    const std::string& recipe_of(const Key& key) const;
    Json made_for(const Key& key, bool in_place) const;

    KeptDocument& document_;
    const SceneContent& content_;
    const std::string& pictures_;
    std::size_t first_texture_ = 0;
    std::map<Key, std::vector<std::array<std::size_t, 2>>> users_;
    std::vector<AtomicFile> files_;
};

}  // namespace burl
