#pragma once
// Reads values out of a glTF's JSON with a type and range check each, and names the place
// ("accessors[3].bufferView") when one is wrong. tinygltf indexes and reads without such checks, so
// load_gltf() passes every file through these first.
#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace burl {

/// Largest size, offset, count or index that is taken, as tinygltf holds some of them in 32-bit
/// integers.
inline constexpr std::uint64_t largest_gltf_integer = 0x7fffffff;

/// Checked access to a glTF's root object; `where` in calls names the object that is read.
class GltfChecker {
  public:
    using Json = nlohmann::json;

    /// `root` and `path` must outlive the checker. Throws Error when `root` is no object or one of
    /// its lists is no array of objects.
    GltfChecker(const Json& root, const std::string& path);

    /// Throws Error(invalid_file) "file: where: message".
    [[noreturn]] void fail(const std::string& where, const std::string& message) const;

    /// The root object, for members of the document itself ("scene").
    const Json& root() const { return root_; }

    /// The top-level array `name`, which holds objects only; an empty array where the document has
    /// none.
    const Json& list(const char* name) const;
    /// Number of elements of the top-level array `name`.
    std::size_t count(const char* name) const;

    /// The member `key` of `object`; null where it is absent. Throws Error(invalid_file) where it
    /// is not an object, an array or a string, respectively.
    const Json* object_in(const Json& object, const char* key, const std::string& where) const;
    const Json* array_in(const Json& object, const char* key, const std::string& where) const;
    const std::string* string_in(const Json& object, const char* key,
                                 const std::string& where) const;
    /// The whole number `key` of `object`, in 0 .. largest_gltf_integer. Throws Error(invalid_file)
    /// for another value and where it is absent.
    std::uint64_t whole(const Json& object, const char* key, const std::string& where) const;
    /// The whole number `key` of `object` as by whole(), or `fallback` where it is absent.
    std::uint64_t whole_or(const Json& object, const char* key, std::uint64_t fallback,
                           const std::string& where) const;
    /// The member `key` of `object` as an index into the top-level array `target`; -1 where it is
    /// absent.
    std::int64_t index_or_none(const Json& object, const char* key, const char* target,
                               const std::string& where) const;
    /// The member `key` of `object` as an index into the top-level array `target`. Throws
    /// Error(invalid_file) where it is absent or out of range.
    std::size_t index(const Json& object, const char* key, const char* target,
                      const std::string& where) const;
    /// The index `value` into the top-level array `target`; throws Error(invalid_file) where it is
    /// none.
    std::size_t as_index(const Json& value, const char* target, const std::string& where) const;
    /// Checks that `key`, if present, is an array of `size` numbers; 0 allows any size.
    void numbers(const Json& object, const char* key, std::size_t size,
                 const std::string& where) const;

  private:
    std::uint64_t as_whole(const Json& value, const std::string& where) const;

    const Json& root_;
    const std::string& path_;
};

/// The text "name[i]", for messages.
std::string place(const char* name, std::size_t i);

/// Throws Error(invalid_file) unless views lie inside the `byteLength` of their buffers, accessors
/// lie inside their views, images, meshes, materials, textures, nodes, skins, scenes, animations
/// and the choice of the scene to draw refer to things that exist, nodes form trees, and accessors
/// without data are used for at most 2^20 elements in all. (check.cpp)
void check_gltf(const GltfChecker& gltf);

}  // namespace burl
