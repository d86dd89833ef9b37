// GLB chunks and uris; after the glTF 2.0 specification, chapters 4 (GLB) and 2.8 (uris).
#include "atlas/gltf/container.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "atlas/base/error.h"
#include "atlas/file/text_scanner.h"

namespace burl {
namespace {

std::uint32_t little_endian_32(const char* bytes) {
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string percent_decoded(std::string_view uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool pair = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 &&
                          hex_digit(uri[i + 2]) >= 0;
        text +=
            pair ? static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])) : uri[i];
        if (pair) i += 2;
    }
    return text;
}

}  // namespace

GltfParts split_gltf(const FileBuffer& file) {
    const std::string_view text = file.text();
    if (!text.starts_with("glTF")) return {text.substr(text_begin(file)), 0, false};
    const auto fail = [&](const char* message) -> Error {
        return invalid_file(file.path, 0, message);
    };
    if (text.size() < 20) throw fail("the GLB header is cut off");
    if (const std::uint32_t version = little_endian_32(&text[4]); version != 2)
        throw invalid_file(file.path, 0, fmt::format("GLB version {}, only 2 is known", version));
    const std::uint64_t length = little_endian_32(&text[8]);
    const std::uint64_t json_bytes = little_endian_32(&text[12]);
    if (length > text.size())
        throw fail("the file is shorter than its GLB header says; it is cut off");
    if (text.substr(16, 4) != "JSON") throw fail("the GLB's first chunk is not JSON");
    if (20 + json_bytes > length) throw fail("the GLB's JSON chunk is longer than the file");
    GltfParts parts{text.substr(20, json_bytes), 0, true};
    const std::uint64_t next = 20 + json_bytes;
    if (next == length) return parts;
    if (next + 8 > length) throw fail("the GLB's second chunk is cut off");
    parts.binary_bytes = little_endian_32(&text[next]);
    if (next + 8 + parts.binary_bytes > length)
        throw fail("the GLB's binary chunk is longer than the file");
    if (text.substr(next + 4, 4) != std::string_view("BIN\0", 4))
        throw fail("the GLB's second chunk is not binary data");
    return parts;
}

bool is_data_uri(std::string_view uri) {
    return uri.starts_with("data:");
}

std::int64_t data_uri_bytes(std::string_view uri) {
    static constexpr std::array<std::string_view, 3> headers{
        "data:application/octet-stream;base64,", "data:application/gltf-buffer;base64,",
        "data:text/plain;base64,"};
    for (const std::string_view header : headers) {
        if (!uri.starts_with(header)) continue;
        std::string_view code = uri.substr(header.size());
        while (code.ends_with('=')) code.remove_suffix(1);
        return static_cast<std::int64_t>(code.size() * 3 / 4);
    }
    return -1;
}

std::string confined_file_name(std::string_view uri, NamedFiles named) {
    std::string name = percent_decoded(uri);
    if (name.empty()) return {};
    if (name.find_first_of(std::string_view(":\\\0", 3)) != std::string::npos) return {};
    if (named == NamedFiles::anywhere) return name;
    if (name.front() == '/') return {};
    std::size_t begin = 0;
    while (begin <= name.size()) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        if (name.substr(begin, end - begin) == "..") return {};
        begin = end + 1;
    }
    return name;
}

}  // namespace burl
