#pragma once
// A glTF's own document, in which carved meshes take the places of old ones: its JSON with every
// member that Burl does not know, and the bytes of its bufferViews.
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/file/file_buffer.h"

namespace burl {

/// The number by which glTF names components that are floats.
inline constexpr int gltf_float = 5126;

/// The elements of an accessor in the file's own encoding, one after the other without gaps.
struct Elements {
    int component_type = 0;
    bool normalized = false;
    std::size_t components = 0;       ///< components of an element
    std::size_t component_bytes = 0;  ///< bytes of a component
    std::size_t element_bytes = 0;    ///< bytes of an element, padding of matrix columns included
    std::vector<std::uint8_t> bytes{};

    std::size_t count() const { return element_bytes == 0 ? 0 : bytes.size() / element_bytes; }
    std::span<const std::uint8_t> operator[](std::size_t i) const {
        return std::span(bytes).subspan(i * element_bytes, element_bytes);
    }
};

/// Kinds of things that a glTF refers to by index.
enum class GltfList { accessors, bufferViews, images, textures, samplers };

class KeptDocument {
  public:
    /// Loads a file with the checks and errors of load_gltf(); its buffers become one, and images
    /// stay encoded.
    explicit KeptDocument(const FileBuffer& file);

    /// The document but for `buffers`; its bufferViews have no offsets until the document is
    /// written.
    Json json;
    /// Sentences about what of the file the document could not keep.
    std::vector<std::string> losses{};
    /// Values for `asset.extras.burl`, a bake after the other.
    std::vector<Json> bakes{};
    /// The uris of images that were added and lie beside the output.
    std::vector<std::string> new_uris{};
    /// The copies of the file's meshes that were made for some of their nodes (mesh and nodes).
    std::map<std::pair<int, std::vector<int>>, std::size_t> copies{};

    const std::string& path() const { return path_; }  ///< of the file
    /// The folder of the file, where images with relative uris lie.
    const std::string& folder() const { return folder_; }
    /// The path of an image's file beside it; empty for a uri that is none, or that leads out of
    /// the folder without leave.
    std::string file_of(const std::string& uri) const;

    std::span<const std::uint8_t> view(std::size_t number) const { return views_[number]; }
    /// Adds a bufferView; returns its number.
    std::size_t add_view(std::vector<std::uint8_t> bytes, std::optional<int> target = {},
                         std::optional<std::size_t> stride = {});

    /// The accessor's elements, sparse replacements applied.
    Elements elements(std::size_t accessor) const;
    /// Adds an accessor of vertices with a view of its own; `like` is the JSON of the accessor that
    /// it stands for, whose type and bounds it has. Returns its number.
    std::size_t add_vertices(const Elements& elements, const Json& like);
    /// Adds an accessor of float vectors of `components` numbers, "VEC2" to "VEC4".
    std::size_t add_floats(std::span<const float> values, std::size_t components);
    /// Adds an accessor of vertex indices, of 16 bits where all of `vertices` vertices allow it.
    std::size_t add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices);

    /// Adds an extension to the list of those used, or takes it from there.
    void use_extension(const std::string& name);
    void forget_extension(const std::string& name);

    /// Whether all extensions are among those whose references are known, so that indices may
    /// change.
    bool knows_references() const;
    /// Removes accessors, bufferViews, textures, samplers and images that nothing refers to any
    /// more and renumbers the others; does nothing unless knows_references().
    void drop_unused();

    /// The pieces of the document's one buffer, in order. Sets the views' offsets and the buffer's
    /// length.
    std::vector<std::span<const std::uint8_t>> lay_out();

  private:
    void drop_unused(GltfList list);

    std::string path_, folder_;
    NamedFiles named_;
    std::deque<std::vector<std::uint8_t>> sources_;  ///< buffers of the file
    std::deque<std::vector<std::uint8_t>> added_;
    std::vector<std::span<const std::uint8_t>> views_;
};

/// The error of a member that has a type of its own; `reason` is the JSON library's.
Error wrong_type(const std::string& path, const std::string& reason);

/// The result of `work` on the document of the file at `path`. Throws Error(invalid_file) where the
/// work meets a member of another type than glTF 2.0 gives it: load_gltf() checks those that it
/// uses, not a name, a flag or extras.
template <class Work>
auto with_types_of_gltf(const std::string& path, const Work& work) {
    try {
        return work();
    } catch (const Json::exception& error) {
        throw wrong_type(path, error.what());
    }
}

/// Removes an extension from an object; returns whether it had that.
bool erase_extension(Json& object, const char* name);

/// Calls visit(reference) for each index into `list` that the document has in places that are
/// known.
void for_each_reference(Json& document, GltfList list, const std::function<void(Json&)>& visit);

}  // namespace burl
