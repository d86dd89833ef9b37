#pragma once
// The document and the pictures of a .glb file, read without the libraries that wrote it.
#include <cstring>
#include <string>

#include "app/base/file_bytes.h"
#include "app/base/json_text.h"
#include "atlas/base/json.h"
#include "tests/app/support/raw_png.h"

namespace burl {

/// A .glb's document and its pictures.
struct Glb {
    explicit Glb(const std::string& path) {
        const std::vector<std::uint8_t> bytes = read_file_bytes(path);
        const auto number = [&](std::size_t at) {
            std::uint32_t n = 0;
            std::memcpy(&n, &bytes[at], 4);
            return std::size_t(n);
        };
        const std::size_t length = number(12), bin = 20 + length + 8;
        document = Json::parse(bytes.begin() + 20, bytes.begin() + std::ptrdiff_t(20 + length));
        for (const Json& image : document["images"]) {
            const Json& view = document["bufferViews"][image["bufferView"].get<std::size_t>()];
            const auto first = bytes.begin() + std::ptrdiff_t(bin + view.value("byteOffset", 0u));
            images.push_back(raw_png({first, first + view["byteLength"].get<std::ptrdiff_t>()}));
        }
    }
    const RawPng& texture(const Json& slot) const {
        const Json& texture = document["textures"].at(slot["index"].get<std::size_t>());
        return images.at(texture["source"].get<std::size_t>());
    }

    Json document;
    std::vector<RawPng> images;
};

}  // namespace burl
