// Checks a glTF, reads the files it names, and only then hands it to tinygltf, whose file access
// goes to what was read here. Afterwards the vertex indices are checked, which only the data can
// tell.
#include "atlas/gltf/document.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <new>

#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/file/text_scanner.h"
#include "atlas/gltf/accessor.h"
#include "atlas/gltf/checker.h"
#include "atlas/gltf/container.h"

namespace burl {
namespace {

using Json = nlohmann::json;

/// Folder given to tinygltf, which looks for files there and in the current one. It exists nowhere,
/// so that tinygltf reaches only files that the callbacks below answer for.
const std::string virtual_folder = "burl-gltf:";

/// Contents of the files that a glTF names, by the path under which tinygltf asks for them.
using Files = std::map<std::string, std::vector<unsigned char>>;

/// Deepest nesting of the JSON that is taken, more than any exporter writes: tinygltf descends by
/// recursion, so depth is stack.
constexpr int deepest_nesting = 256;

void check_nesting(std::string_view json, const std::string& path) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '"') in_string = !in_string;
        if (in_string && c == '\\') ++i;
        if (in_string) continue;
        depth += (c == '[' || c == '{') - (c == ']' || c == '}');
        if (depth > deepest_nesting)
            throw invalid_file(
                path, 0,
                fmt::format("the JSON is nested more than {} levels deep", deepest_nesting));
    }
}

Json parse_json(const FileBuffer& file, const GltfParts& parts) {
    check_nesting(parts.json, file.path);
    try {
        return Json::parse(parts.json);
    } catch (const Json::parse_error& error) {
        const std::size_t at = std::min(error.byte, parts.json.size());
        const auto newlines = std::count(
            parts.json.begin(), parts.json.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        throw invalid_file(file.path, parts.is_glb ? 0 : static_cast<std::size_t>(newlines) + 1,
                           fmt::format("this is not valid JSON (byte {} of it)", at));
    } catch (const Json::exception&) {
        throw invalid_file(file.path, 0, "the JSON holds a number that is out of range");
    }
}

/// Whether a required extension can be read: one that changes only the look or the number of
/// copies, not the geometry, or KHR_mesh_quantization, which read_accessor() decodes.
bool understood(const std::string& extension) {
    static constexpr std::array prefixes{
        "KHR_materials_", "KHR_texture_", "EXT_texture_",          "KHR_lights_",
        "KHR_xmp",        "KHR_node_",    "KHR_animation_pointer", "EXT_mesh_gpu_instancing"};
    return extension == "KHR_mesh_quantization" ||
           std::any_of(prefixes.begin(), prefixes.end(),
                       [&](const char* prefix) { return extension.starts_with(prefix); });
}

/// The list of names that is the member `key` of the root; null if there is none.
const Json* names_in(const GltfChecker& gltf, const Json& root, const char* key) {
    const Json* names = gltf.array_in(root, key, "glTF");
    if (names && !std::ranges::all_of(*names, [](const Json& name) { return name.is_string(); }))
        gltf.fail(key, "must hold strings only");
    return names;
}

void check_extensions(const GltfChecker& gltf, const Json& root, const std::string& path) {
    names_in(gltf, root, "extensionsUsed");
    const Json* required = names_in(gltf, root, "extensionsRequired");
    if (required == nullptr) return;
    for (const Json& name : *required) {
        if (!understood(name.get_ref<const std::string&>()))
            throw Error(ExitCode::unsupported,
                        fmt::format("{}: the file requires the glTF extension {}, which is not "
                                    "supported; export it without",
                                    path, printable(name.get_ref<const std::string&>())));
    }
}

void check_version(const GltfChecker& gltf, const Json& root) {
    const Json* asset = gltf.object_in(root, "asset", "glTF");
    const std::string* version =
        asset == nullptr ? nullptr : gltf.string_in(*asset, "version", "asset");
    if (version == nullptr) gltf.fail("asset", "'version' is missing; this is no glTF 2.0 file");
    if (!version->starts_with("2."))
        gltf.fail("asset",
                  fmt::format("glTF version '{}', only 2.x is known", printable(*version)));
}

std::vector<unsigned char> bytes_of(const FileBuffer& file, std::size_t size) {
    return {file.bytes.get(), file.bytes.get() + size};
}

/// The path of a file that the document names.
std::string beside(const FileBuffer& document, const std::string& name) {
    return (std::filesystem::path(document.path).parent_path() / name).string();
}

/// Checks that buffer `i` has its bytes, and reads them when they are in a file of their own.
void check_buffer(const GltfChecker& gltf, const Json& buffer, std::size_t i,
                  const GltfParts& parts, const FileBuffer& document, Files& files) {
    const std::string where = place("buffers", i);
    const std::uint64_t size = gltf.whole(buffer, "byteLength", where);
    const std::string* uri = gltf.string_in(buffer, "uri", where);
    const auto expect = [&](std::uint64_t held) {
        if (held < size)
            gltf.fail(where,
                      fmt::format("'byteLength' is {}, but only {} bytes are there", size, held));
    };
    if (uri == nullptr) {
        if (i != 0 || !parts.is_glb) gltf.fail(where, "'uri' is missing");
        return expect(parts.binary_bytes);
    }
    if (is_data_uri(*uri)) {
        const std::int64_t held = data_uri_bytes(*uri);
        if (held < 0) gltf.fail(where, "the data uri is not base64 of a known type");
        if (static_cast<std::uint64_t>(held) != size)
            gltf.fail(where,
                      fmt::format("'byteLength' is {}, but the data uri holds {}", size, held));
        return;
    }
    const std::string name = confined_file_name(*uri, document.named);
    if (name.empty())
        gltf.fail(where, fmt::format("the uri '{}' {}", printable(*uri), confined_rule));
    if (!may_name(document.named, document.path, name))
        gltf.fail(where, fmt::format("'{}' {}", printable(name), outside_rule));
    const FileBuffer file = read_file(beside(document, name));
    expect(file.size);
    files[virtual_folder + '/' + name] = bytes_of(file, size);
}

/// Reads an image's file when it is there; a missing one is no reason to refuse the geometry.
void read_image(const GltfChecker& gltf, const Json& image, const FileBuffer& document,
                Files& files) {
    const std::string* uri = gltf.string_in(image, "uri", "images");
    if (uri == nullptr || is_data_uri(*uri)) return;
    const std::string name = confined_file_name(*uri, document.named);
    if (name.empty() || !may_name(document.named, document.path, name)) return;
    try {
        const FileBuffer file = read_file(beside(document, name));
        if (file.size <= largest_gltf_integer)
            files[virtual_folder + '/' + name] = bytes_of(file, file.size);
    } catch (const Error&) {
    }
}

bool file_exists(const std::string& name, void* files) {
    return static_cast<const Files*>(files)->contains(name);
}

bool read_whole_file(std::vector<unsigned char>* out, std::string*, const std::string& name,
                     void* files) {
    const auto& all = *static_cast<const Files*>(files);
    const auto found = all.find(name);
    if (found == all.end()) return false;
    *out = found->second;
    return true;
}

/// An image loader for tinygltf that keeps the encoded bytes instead of decoding them.
bool keep_encoded(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
    image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

tinygltf::Model parse_checked(const FileBuffer& file, const GltfParts& parts, Files& files) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keep_encoded, nullptr);
    loader.SetFsCallbacks({file_exists, [](const std::string& name, void*) { return name; },
                           read_whole_file,
                           [](std::string*, const std::string&, const std::vector<unsigned char>&,
                              void*) { return false; },
                           &files});
    tinygltf::Model model;
    std::string error, warning;
    bool loaded = false;
    try {
        const auto size = static_cast<unsigned>(parts.is_glb ? file.size : parts.json.size());
        loaded = parts.is_glb ? loader.LoadBinaryFromMemory(
                                    &model, &error, &warning,
                                    reinterpret_cast<const unsigned char*>(file.bytes.get()), size,
                                    virtual_folder)
                              : loader.LoadASCIIFromString(&model, &error, &warning,
                                                           parts.json.data(), size, virtual_folder);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& failure) {  // thrown by the JSON library inside it
        error = failure.what();
    }
    if (!loaded) {
        const std::string first_line = error.substr(0, error.find('\n'));
        throw invalid_file(file.path, 0,
                           fmt::format("not a sound glTF: {}", printable(first_line, 200)));
    }
    return model;
}

bool view_fits(const tinygltf::Model& model, const tinygltf::BufferView& view) {
    const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    return view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset;
}

std::int64_t largest_index(const tinygltf::Model& model, int accessor) {
    const std::vector<std::uint32_t> indices = read_indices(model, accessor);
    return indices.empty() ? 0 : *std::max_element(indices.begin(), indices.end());
}

/// Checks what the JSON cannot tell: that the buffers hold what they promise, and that the indices
/// found in them are in range.
void check_contents(const tinygltf::Model& model, const std::string& path) {
    for (const tinygltf::BufferView& view : model.bufferViews)
        if (!view_fits(model, view)) throw invalid_file(path, 0, "a bufferView leaves its buffer");
    for (std::size_t i = 0; i < model.accessors.size(); ++i)
        if (!sparse_indices_in_range(model, static_cast<int>(i)))
            throw invalid_file(path, 0,
                               place("accessors", i) + ".sparse: an index is out of range");
    std::vector<std::int64_t> largest(model.accessors.size(), -1);  // largest index, -1: unread
    for (std::size_t m = 0; m < model.meshes.size(); ++m)
        for (const tinygltf::Primitive& primitive : model.meshes[m].primitives) {
            if (primitive.indices < 0 || primitive.attributes.empty()) continue;
            std::int64_t& index = largest[static_cast<std::size_t>(primitive.indices)];
            if (index < 0) index = largest_index(model, primitive.indices);
            const auto attribute = static_cast<std::size_t>(primitive.attributes.begin()->second);
            const std::size_t vertices = model.accessors[attribute].count;
            if (static_cast<std::size_t>(index) >= vertices)
                throw invalid_file(path, 0,
                                   fmt::format("meshes[{}]: vertex index {}, but its primitive has "
                                               "{} vertices (the first is 0)",
                                               m, index, vertices));
        }
}

}  // namespace

tinygltf::Model load_gltf(const std::string& path) {
    return load_gltf(read_file(path));
}

tinygltf::Model load_gltf(const FileBuffer& file) {
    const std::string& path = file.path;
    if (file.size == 0) throw invalid_file(path, 0, "the file is empty");
    if (file.size > largest_gltf_integer)
        throw Error(ExitCode::unsupported, fmt::format("{}: larger than 2 GiB", path));
    const GltfParts parts = split_gltf(file);
    Files files;
    {
        const Json root = parse_json(file, parts);
        const GltfChecker gltf(root, path);
        check_version(gltf, root);
        check_extensions(gltf, root, path);
        const Json& buffers = gltf.list("buffers");
        for (std::size_t i = 0; i < buffers.size(); ++i)
            check_buffer(gltf, buffers[i], i, parts, file, files);
        check_gltf(gltf);
        for (const Json& image : gltf.list("images")) read_image(gltf, image, file, files);
    }
    tinygltf::Model model = parse_checked(file, parts, files);
    check_contents(model, path);
    return model;
}

}  // namespace burl
