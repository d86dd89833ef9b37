// Typed and range-checked access to a glTF's JSON.
#include "atlas/gltf/checker.h"

#include <cmath>

#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/file/text_scanner.h"

namespace burl {

std::string place(const char* name, std::size_t i) {
    return fmt::format("{}[{}]", name, i);
}

GltfChecker::GltfChecker(const Json& root, const std::string& path) : root_(root), path_(path) {
    if (!root.is_object()) throw invalid_file(path, 0, "the glTF's JSON is not an object");
    for (const char* name :
         {"accessors", "animations", "buffers", "bufferViews", "cameras", "images", "materials",
          "meshes", "nodes", "samplers", "scenes", "skins", "textures"}) {
        const Json& objects = list(name);
        if (!objects.is_array()) fail(name, "must be an array");
        for (std::size_t i = 0; i < objects.size(); ++i)
            if (!objects[i].is_object()) fail(place(name, i), "must be an object");
    }
}

void GltfChecker::fail(const std::string& where, const std::string& message) const {
    throw invalid_file(path_, 0, fmt::format("{}: {}", where, message));
}

const GltfChecker::Json& GltfChecker::list(const char* name) const {
    static const Json none = Json::array();
    const auto found = root_.find(name);
    return found == root_.end() ? none : *found;
}

std::size_t GltfChecker::count(const char* name) const {
    return list(name).size();
}

const GltfChecker::Json* GltfChecker::object_in(const Json& object, const char* key,
                                                const std::string& where) const {
    const auto found = object.find(key);
    if (found == object.end()) return nullptr;
    if (!found->is_object()) fail(where + '.' + key, "must be an object");
    return &*found;
}

const GltfChecker::Json* GltfChecker::array_in(const Json& object, const char* key,
                                               const std::string& where) const {
    const auto found = object.find(key);
    if (found == object.end()) return nullptr;
    if (!found->is_array()) fail(where + '.' + key, "must be an array");
    return &*found;
}

const std::string* GltfChecker::string_in(const Json& object, const char* key,
                                          const std::string& where) const {
    const auto found = object.find(key);
    if (found == object.end()) return nullptr;
    if (!found->is_string()) fail(where + '.' + key, "must be a string");
    return found->get_ptr<const std::string*>();
}

std::uint64_t GltfChecker::as_whole(const Json& value, const std::string& where) const {
    // 5.0 is a whole number to JSON, and some exporters write it so.
    double number = -1.0;
    if (value.is_number()) number = value.get<double>();
    if (!(number >= 0.0) || number != std::floor(number))
        fail(where, "must be a whole number that is not negative");
    if (number > static_cast<double>(largest_gltf_integer))
        fail(where, fmt::format("{:.0f} is too large", number));
    return static_cast<std::uint64_t>(number);
}

std::uint64_t GltfChecker::whole(const Json& object, const char* key,
                                 const std::string& where) const {
    const auto found = object.find(key);
    if (found == object.end()) fail(where, fmt::format("'{}' is missing", key));
    return as_whole(*found, where + '.' + key);
}

std::uint64_t GltfChecker::whole_or(const Json& object, const char* key, std::uint64_t fallback,
                                    const std::string& where) const {
    return object.contains(key) ? whole(object, key, where) : fallback;
}

std::size_t GltfChecker::as_index(const Json& value, const char* target,
                                  const std::string& where) const {
    const std::uint64_t index = as_whole(value, where);
    const std::size_t held = count(target);
    if (index >= held)
        fail(where,
             fmt::format("index {}, but there are {} {} (the first is 0)", index, held, target));
    return index;
}

std::int64_t GltfChecker::index_or_none(const Json& object, const char* key, const char* target,
                                        const std::string& where) const {
    const auto found = object.find(key);
    if (found == object.end()) return -1;
    return static_cast<std::int64_t>(as_index(*found, target, where + '.' + key));
}

std::size_t GltfChecker::index(const Json& object, const char* key, const char* target,
                               const std::string& where) const {
    const std::int64_t found = index_or_none(object, key, target, where);
    if (found < 0) fail(where, fmt::format("'{}' is missing", key));
    return static_cast<std::size_t>(found);
}

void GltfChecker::numbers(const Json& object, const char* key, std::size_t size,
                          const std::string& where) const {
    const Json* values = array_in(object, key, where);
    if (values == nullptr) return;
    if (size != 0 && values->size() != size)
        fail(where + '.' + key, fmt::format("must hold {} numbers", size));
    for (const Json& value : *values)
        if (!value.is_number()) fail(where + '.' + key, "must hold numbers only");
}

}  // namespace burl
