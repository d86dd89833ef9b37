#include "app/export/gltf_file.h"

#include <filesystem>

#include <fmt/format.h>

#include "atlas/base/json.h"

namespace burl {
namespace {

template <std::size_t Count>
std::array<std::uint8_t, 4 * Count> as_words(const std::array<std::uint64_t, Count>& words) {
    std::array<std::uint8_t, 4 * Count> bytes{};
    for (std::size_t k = 0; k < bytes.size(); ++k)
        bytes[k] = std::uint8_t(words[k / 4] >> (8 * (k % 4)));
    return bytes;
}

}  // namespace

Error glb_too_long(const std::string& path) {
    return Error(ExitCode::unsupported,
                 fmt::format("{}: the result has more than 4 GiB, which no .glb holds; write a "
                             ".gltf instead",
                             path));
}

std::string gltf_text(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string glb_head(const std::string& json, std::size_t length, std::uint64_t binary_size) {
    std::string head;
    const auto append = [&](const auto& bytes) { head.append(bytes.begin(), bytes.end()); };
    append(as_words<5>({0x46546C67, 2, 28 + length + binary_size, length, 0x4E4F534A}));
    head += json;
    head.resize(20 + length, ' ');
    append(as_words<2>({binary_size, 0x004E4942}));
    return head;
}

std::string relative_uri(const std::string& path) {
    std::string uri;
    for (const char c : std::filesystem::path(path).filename().string()) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
                           (byte >= 'a' && byte <= 'z') || byte == '-' || byte == '.' ||
                           byte == '_' || byte == '~';
        uri += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return uri;
}

}  // namespace burl
