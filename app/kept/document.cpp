// Bytes of the source stay where they were loaded; what is added has memory of its own.
#include "app/kept/document.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "atlas/file/text_scanner.h"
#include "atlas/gltf/container.h"
#include "atlas/gltf/document.h"

namespace burl {
namespace {

enum Gl { gl_array_buffer = 34962, gl_element_array_buffer = 34963 };
constexpr int unsigned_short = 5123, unsigned_int = 5125;

std::size_t number(const Json& object, const char* key, std::size_t otherwise = 0) {
    const auto found = object.find(key);
    return found == object.end() ? otherwise : found->get<std::size_t>();
}

std::size_t bytes_of(int component_type) {
    return component_type < 5122 ? 1 : component_type < 5124 ? 2 : 4;
}

/// An accessor's elements without their bytes.
Elements layout_of(const Json& accessor) {
    const std::string type = accessor.at("type");
    Elements result;
    result.component_type = accessor.at("componentType");
    result.normalized = accessor.value("normalized", false);
    result.component_bytes = bytes_of(result.component_type);
    const std::size_t rows = type == "SCALAR" ? 1 : std::size_t(type.back() - '0');
    const bool matrix = type.starts_with("MAT");
    const std::size_t row_bytes = rows * result.component_bytes;
    result.components = matrix ? rows * rows : rows;
    result.element_bytes = matrix ? rows * ((row_bytes + 3) / 4 * 4) : row_bytes;
    return result;
}

std::size_t index_at(std::span<const std::uint8_t> bytes, std::size_t size) {
    std::size_t value = 0;
    for (std::size_t k = size; k-- > 0;) value = value << 8 | bytes[k];
    return value;
}

/// Extensions that refer to nothing, or in places that for_each_reference() knows.
constexpr std::array known_prefixes{"KHR_materials_", "KHR_lights_",       "KHR_texture_transform",
                                    "KHR_xmp",        "KHR_node_",         "KHR_animation_pointer",
                                    "EXT_texture_",   "KHR_texture_basisu"};
constexpr std::array known_extensions{"KHR_mesh_quantization", "KHR_draco_mesh_compression",
                                      "EXT_mesh_gpu_instancing", "MSFT_lod", "MSFT_texture_dds"};

const char* name_of(GltfList list) {
    constexpr std::array names{"accessors", "bufferViews", "images", "textures", "samplers"};
    return names[std::size_t(list)];
}

/// Copies of bytes that a vertex attribute's view has: elements begin at multiples of four bytes.
std::vector<std::uint8_t> aligned(const Elements& elements, std::size_t stride) {
    if (stride == elements.element_bytes) return elements.bytes;
    std::vector<std::uint8_t> bytes(stride * elements.count(), 0);
    for (std::size_t i = 0; i < elements.count(); ++i)
        std::ranges::copy(elements[i], bytes.begin() + std::ptrdiff_t(i * stride));
    return bytes;
}

}  // namespace

bool erase_extension(Json& object, const char* name) {
    const auto extensions = object.find("extensions");
    if (extensions == object.end() || !extensions->is_object()) return false;
    if (extensions->erase(name) == 0) return false;
    if (extensions->empty()) object.erase(extensions);
    return true;
}

Error wrong_type(const std::string& path, const std::string& reason) {
    const std::string said = reason.substr(std::min(reason.find("] ") + 2, reason.size()));
    return Error(ExitCode::invalid_file,
                 fmt::format("{}: a member of the glTF has another type than glTF 2.0 gives it "
                             "({}); a validator names it, and an output of another format keeps "
                             "nothing of it",
                             path, printable(said)));
}

KeptDocument::KeptDocument(const FileBuffer& file)
    : path_(file.path),
      folder_(std::filesystem::path(file.path).parent_path().string()),
      named_(file.named) {
    tinygltf::Model model = load_gltf(file);
    json = Json::parse(split_gltf(file).json);
    for (tinygltf::Buffer& buffer : model.buffers) sources_.push_back(std::move(buffer.data));
    if (!json.contains("bufferViews")) json["bufferViews"] = Json::array();
    for (Json& view : json["bufferViews"]) {
        const std::vector<std::uint8_t>& buffer = sources_[number(view, "buffer")];
        views_.push_back(
            std::span(buffer).subspan(number(view, "byteOffset"), number(view, "byteLength")));
        view["buffer"] = 0;
        if (!erase_extension(view, "EXT_meshopt_compression") || !losses.empty()) continue;
        losses.emplace_back(
            "EXT_meshopt_compression: the buffers' compressed copies are left out, their "
            "uncompressed data is kept");
    }
    json.erase("buffers");
}

std::string KeptDocument::file_of(const std::string& uri) const {
    const std::string name = is_data_uri(uri) ? "" : confined_file_name(uri, named_);
    if (name.empty()) return {};
    const std::string folder = (std::filesystem::path(folder_) / "").string();
    if (!may_name(named_, folder, name)) return {};
    return folder + name;
}

std::size_t KeptDocument::add_view(std::vector<std::uint8_t> bytes, std::optional<int> target,
                                   std::optional<std::size_t> stride) {
    Json view{{"buffer", 0}, {"byteLength", bytes.size()}};
    if (stride) view["byteStride"] = *stride;
    if (target) view["target"] = *target;
    json["bufferViews"].push_back(std::move(view));
    views_.push_back(added_.emplace_back(std::move(bytes)));
    return views_.size() - 1;
}

Elements KeptDocument::elements(std::size_t accessor) const {
    const Json& source = json.at("accessors").at(accessor);
    Elements result = layout_of(source);
    const std::size_t size = result.element_bytes;
    result.bytes.resize(number(source, "count") * size, 0);
    const auto place = [&](std::size_t i) { return result.bytes.data() + i * size; };
    if (source.contains("bufferView")) {
        const std::size_t v = number(source, "bufferView");
        const auto bytes = view(v).subspan(number(source, "byteOffset"));
        const std::size_t stride = number(json.at("bufferViews")[v], "byteStride", size);
        for (std::size_t i = 0; i < result.count(); ++i)
            std::memcpy(place(i), bytes.data() + i * stride, size);
    }
    if (const auto sparse = source.find("sparse"); sparse != source.end()) {
        const Json &indices = sparse->at("indices"), &values = sparse->at("values");
        const std::size_t width = bytes_of(indices.at("componentType"));
        auto at = view(number(indices, "bufferView")).subspan(number(indices, "byteOffset"));
        auto from = view(number(values, "bufferView")).subspan(number(values, "byteOffset"));
        for (std::size_t i = 0; i < number(*sparse, "count"); ++i)
            std::memcpy(place(index_at(at.subspan(i * width), width)), from.data() + i * size,
                        size);
    }
    return result;
}

std::size_t KeptDocument::add_vertices(const Elements& elements, const Json& like) {
    const std::size_t stride = (elements.element_bytes + 3) / 4 * 4;
    const bool padded = stride != elements.element_bytes;
    Json accessor = like;
    for (const char* key : {"byteOffset", "sparse"}) accessor.erase(key);
    accessor["bufferView"] = add_view(aligned(elements, stride), gl_array_buffer,
                                      padded ? std::optional(stride) : std::nullopt);
    accessor["count"] = elements.count();
    json["accessors"].push_back(std::move(accessor));
    return json["accessors"].size() - 1;
}

std::size_t KeptDocument::add_floats(std::span<const float> values, std::size_t components) {
    Elements elements{gltf_float, false, components, 4, 4 * components, {}};
    elements.bytes.resize(values.size_bytes());
    if (!values.empty()) std::memcpy(elements.bytes.data(), values.data(), values.size_bytes());
    return add_vertices(elements, {{"bufferView", 0},
                                   {"componentType", gltf_float},
                                   {"count", 0},
                                   {"type", fmt::format("VEC{}", components)}});
}

std::size_t KeptDocument::add_indices(const std::vector<std::uint32_t>& indices,
                                      std::size_t vertices) {
    const bool narrow = vertices <= 65535;  // 65535 itself restarts primitives
    const std::size_t width = narrow ? 2 : 4;
    std::vector<std::uint8_t> bytes(width * indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
        for (std::size_t k = 0; k < width; ++k)
            bytes[width * i + k] = std::uint8_t(indices[i] >> (8 * k));
    const std::size_t view = add_view(std::move(bytes), gl_element_array_buffer);
    json["accessors"].push_back({{"bufferView", view},
                                 {"componentType", narrow ? unsigned_short : unsigned_int},
                                 {"count", indices.size()},
                                 {"type", "SCALAR"}});
    return json["accessors"].size() - 1;
}

void KeptDocument::use_extension(const std::string& name) {
    Json& used = json["extensionsUsed"];
    if (std::ranges::find(used, Json(name)) == used.end()) used.push_back(name);
}

void KeptDocument::forget_extension(const std::string& name) {
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        if (!json.contains(list)) continue;
        Json& names = json[list];
        const auto found = std::ranges::find(names, Json(name));
        if (found != names.end()) names.erase(found);
        if (names.empty()) json.erase(list);
    }
}

bool KeptDocument::knows_references() const {
    const auto used = json.find("extensionsUsed");
    if (used == json.end()) return true;
    return std::ranges::all_of(*used, [](const Json& entry) {
        const std::string name = entry.get<std::string>();
        return std::ranges::any_of(known_prefixes,
                                   [&](const char* prefix) { return name.starts_with(prefix); }) ||
               std::ranges::find(known_extensions, name) != known_extensions.end();
    });
}

void KeptDocument::drop_unused() {
    if (!knows_references()) return;
    for (const GltfList list : {GltfList::textures, GltfList::samplers, GltfList::images,
                                GltfList::accessors, GltfList::bufferViews})
        drop_unused(list);
}

void KeptDocument::drop_unused(GltfList list) {
    const auto found = json.find(name_of(list));
    if (found == json.end()) return;
    std::vector<bool> used(found->size(), false);
    // No reader checks all references; one to nothing stays one, since lists only get shorter.
    const auto visit = [&](const auto& visit_number) {
        for_each_reference(json, list, [&](Json& index) {
            const double number = index.is_number() ? index.get<double>() : -1.0;
            if (number >= 0.0 && number < double(used.size())) visit_number(index);
        });
    };
    visit([&](Json& index) { used[index.get<std::size_t>()] = true; });
    std::vector<std::size_t> new_number(used.size());
    Json kept = Json::array();
    std::vector<std::span<const std::uint8_t>> views;
    for (std::size_t i = 0; i < used.size(); ++i) {
        new_number[i] = kept.size();
        if (!used[i]) continue;
        kept.push_back(std::move((*found)[i]));
        if (list == GltfList::bufferViews) views.push_back(views_[i]);
    }
    visit([&](Json& index) { index = new_number[index.get<std::size_t>()]; });
    if (list == GltfList::bufferViews) views_ = std::move(views);
    if (kept.empty())
        json.erase(name_of(list));
    else
        json[name_of(list)] = std::move(kept);
}

// Views of one buffer may overlap, so that copies of all could be far longer than the file.
std::vector<std::span<const std::uint8_t>> KeptDocument::lay_out() {
    if (!json.contains("bufferViews")) json["bufferViews"] = Json::array();
    const auto source_of = [&](std::span<const std::uint8_t> bytes) {
        for (std::size_t s = 0; s < sources_.size(); ++s) {
            const std::vector<std::uint8_t>& source = sources_[s];
            if (!source.empty() && std::less_equal<>()(source.data(), bytes.data()) &&
                std::less<>()(bytes.data(), source.data() + source.size()))
                return s;
        }
        return sources_.size();
    };
    std::uint64_t held = 0, shown = 0, length = 0;
    for (const auto& source : sources_) held += source.size();
    for (const auto& bytes : views_)
        if (source_of(bytes) < sources_.size()) shown += bytes.size();
    std::vector<std::span<const std::uint8_t>> pieces;
    std::vector<std::uint64_t> starts;
    const auto append = [&](std::span<const std::uint8_t> bytes) {
        pieces.push_back(bytes);
        starts.push_back(length);
        length += (bytes.size() + 3) / 4 * 4;
        return starts.back();
    };
    const bool overlap = shown > held;
    for (std::size_t s = 0; s < sources_.size() && overlap; ++s) append(sources_[s]);
    for (std::size_t v = 0; v < views_.size(); ++v) {
        const std::size_t s = source_of(views_[v]);
        json["bufferViews"][v]["byteOffset"] =
            overlap && s < sources_.size()
                ? starts[s] + std::uint64_t(views_[v].data() - sources_[s].data())
                : append(views_[v]);
    }
    if (json["bufferViews"].empty()) json.erase("bufferViews");
    json["buffers"] = Json::array({{{"byteLength", length}}});
    if (length == 0) json.erase("buffers");
    return pieces;
}

}  // namespace burl
