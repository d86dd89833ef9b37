#pragma once
// Reads values out of a glTF's JSON with a type and range check each, and names the place
// ("accessors[3].bufferView") when one is wrong. tinygltf indexes and reads without such checks, so
// load_gltf() passes every file through these first.
#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace burl {

/// Sizes, offsets and counts stay below this, as tinygltf holds some of them in 32-bit integers.
inline constexpr std::uint64_t largest_gltf_integer = 0x7fffffff;

class GltfChecker {
  public:
    using Json = nlohmann::json;

    /// `root` and `path` must outlive the checker. Throws Error when `root` is no object or one of
    /// its lists is no array of objects.
    GltfChecker(const Json& root, const std::string& path);

    /// Throws Error(invalid_file) "file: where: message".
    [[noreturn]] void fail(const std::string& where, const std::string& message) const;

    /// The whole document, for what it says itself ("scene").
    const Json& root() const { return root_; }

    /// The top-level array `name`, which holds objects only; an empty array when there is none.
    const Json& list(const char* name) const;
    std::size_t count(const char* name) const;

    /// `key` of `object`, or null when absent. Throws unless it is of the kind asked for.
    const Json* object_in(const Json& object, const char* key, const std::string& where) const;
    const Json* array_in(const Json& object, const char* key, const std::string& where) const;
    const std::string* string_in(const Json& object, const char* key,
                                 const std::string& where) const;
    /// A whole number in 0 .. largest_gltf_integer; throws when it is absent.
    std::uint64_t whole(const Json& object, const char* key, const std::string& where) const;
    std::uint64_t whole_or(const Json& object, const char* key, std::uint64_t fallback,
                           const std::string& where) const;
    /// An index into the top-level array `target`; -1 when absent.
    std::int64_t index_or_none(const Json& object, const char* key, const char* target,
                               const std::string& where) const;
    std::size_t index(const Json& object, const char* key, const char* target,
                      const std::string& where) const;
    /// Checks that `value` itself is an index into `target`.
    std::size_t as_index(const Json& value, const char* target, const std::string& where) const;
    /// Checks that `key`, if present, is an array of `size` numbers (any number of them for 0).
    void numbers(const Json& object, const char* key, std::size_t size,
                 const std::string& where) const;

  private:
    std::uint64_t as_whole(const Json& value, const std::string& where) const;

    const Json& root_;
    const std::string& path_;
};

/// "name[i]"
std::string place(const char* name, std::size_t i);

/// Buffers' views and accessors lie inside the `byteLength` of their buffers; images name one of
/// them or a uri. (gltf_check_data.cpp)
void check_gltf_data(const GltfChecker& gltf);

/// Meshes, materials, textures, nodes, skins, scenes and animations refer to things that exist, as
/// does the scene to draw; nodes form trees; accessors without data are named for few elements in
/// all. (gltf_check_scene.cpp)
void check_gltf_scene(const GltfChecker& gltf);

}  // namespace burl
