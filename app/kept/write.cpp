// Files of a kept document.
#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "app/export/export.h"
#include "app/export/gltf_file.h"
#include "app/export/gltf_scene.h"
#include "app/image/picture_read.h"
#include "app/kept/carve.h"
#include "atlas/base/error.h"
#include "atlas/base/real_path.h"
#include "atlas/file/file_extension.h"
#include "atlas/gltf/container.h"

namespace burl {
namespace {

namespace fs = std::filesystem;

/// The media type of encoded image bytes, from their signature; empty for an unknown one.
std::string_view media_type_of(std::span<const std::uint8_t> bytes) {
    switch (picture_type(bytes)) {
        case PictureType::png:
            return media_type(TextureFormat::png);
        case PictureType::jpeg:
            return media_type(TextureFormat::jpeg);
        case PictureType::webp:
            return media_type(TextureFormat::webp);
        case PictureType::ktx2:
            return media_type(TextureFormat::ktx2);
        default:
            return "";
    }
}

/// The reason why the image's file does not go into the document, which takes it where there is
/// none.
std::string_view not_embedded(KeptDocument& document, Json& image, const std::string& path) {
    if (path.empty()) return "lies outside the folder of the file that names it";
    try {
        const FileBuffer file = read_file(path);
        std::vector<std::uint8_t> bytes(file.bytes.get(), file.bytes.get() + file.size);
        const std::string_view type = media_type_of(bytes);
        if (type.empty()) return "is no PNG, JPEG, WebP or KTX2";
        image["bufferView"] = document.add_view(std::move(bytes));
        image["mimeType"] = type;
        image.erase("uri");
        return "";
    } catch (const Error&) {
        return "is not there";
    }
}

/// Takes an image that lies in a file beside the source into the document. One that does not go
/// there stays as it is named, and is a loss: from the output's folder its name may lead elsewhere.
void embed(KeptDocument& document, Json& image) {
    const std::string uri = image.at("uri");
    if (is_data_uri(uri)) return;
    const std::string_view reason = not_embedded(document, image, document.file_of(uri));
    if (!reason.empty())
        document.losses.push_back(
            fmt::format("image {}: the file {}; its name is kept", uri, reason));
}

/// Takes images of the source into the document unless the output lies beside them.
void embed_images(KeptDocument& document, const std::string& path, bool is_glb) {
    if (!document.json.contains("images")) return;
    const auto folder = [](const std::string& of) { return real_path(of.empty() ? "." : of); };
    const bool beside = folder(document.folder()) == folder(fs::path(path).parent_path().string());
    if (beside && !is_glb) return;
    const std::vector<std::string>& ours = document.new_uris;
    for (Json& image : document.json["images"])
        if (image.contains("uri") &&
            std::ranges::find(ours, image["uri"].get<std::string>()) == ours.end())
            embed(document, image);
}

void write_pieces(AtomicFile& file, const std::vector<std::span<const std::uint8_t>>& pieces) {
    for (const auto& bytes : pieces) {
        file.write(bytes);
        file.write(padding_after(bytes.size()));
    }
}

/// Whether an object anywhere in the value has the extension.
bool has_extension(const Json& value, const char* name) {
    if (!value.is_structured()) return false;
    if (value.is_object() && value.contains("extensions") && value["extensions"].contains(name))
        return true;
    return std::ranges::any_of(value, [&](const Json& part) { return has_extension(part, name); });
}

/// Takes extensions off the lists that only described what has been replaced, and says in
/// asset.extras what was baked: an object, or a list of several.
void tidy(KeptDocument& document) {
    for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                             "EXT_texture_webp", "KHR_texture_basisu", "KHR_texture_transform"})
        if (!has_extension(document.json, name)) document.forget_extension(name);
    Json& extras = document.json["asset"]["extras"];
    if (!extras.is_object()) {
        if (!extras.is_null())
            document.losses.emplace_back("asset.extras, which is no object that could hold Burl's");
        extras = Json::object();
    }
    extras["burl"] = document.bakes.size() == 1 ? document.bakes.front() : Json(document.bakes);
}

std::uint64_t length_of(const Json& document) {
    return document.contains("buffers") ? document["buffers"][0]["byteLength"].get<std::uint64_t>()
                                        : 0;
}

}  // namespace

std::vector<AtomicFile> write_kept(KeptDocument& document, const std::string& path) {
    const bool is_glb = lower_extension(path) == ".glb";
    document.drop_unused();
    tidy(document);
    embed_images(document, path, is_glb);
    const auto pieces = document.lay_out();
    std::vector<AtomicFile> files;
    if (!is_glb) {
        const std::string buffer = fs::path(path).replace_extension(".bin").string();
        if (document.json.contains("buffers"))
            document.json["buffers"][0]["uri"] = relative_uri(buffer);
        write_pieces(files.emplace_back(buffer), pieces);
        files.emplace_back(path).write(gltf_text(document.json, 2) + "\n");
        return files;
    }
    const std::string json = gltf_text(document.json, -1);
    const std::size_t length = (json.size() + 3) / 4 * 4;
    const std::string head = glb_head(json, length, length_of(document.json));
    if (head.size() + length_of(document.json) > most_glb_bytes) throw glb_too_long(path);
    AtomicFile& file = files.emplace_back(path);
    file.write(head);
    write_pieces(file, pieces);
    return files;
}

}  // namespace burl
