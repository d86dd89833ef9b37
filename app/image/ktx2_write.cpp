// KTX2 (Khronos, "KTX File Format Specification", version 2.0.4): header, index of levels, data
// format descriptor (Khronos, "Data Format Specification" 1.3, the basic block), key and value
// data, and the levels, the smallest first. All numbers have their lowest byte first.
#include <algorithm>
#include <bit>
#include <memory>
#include <numeric>

#include <zstd.h>

#include "app/image/picture_coding.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

using KtxBytes = std::vector<std::uint8_t>;

enum VkFormat : std::uint32_t {  // Vulkan's numbers
    vk_r8_unorm = 9,
    vk_r8g8b8a8_unorm = 37,
    vk_r8g8b8a8_srgb = 43,
};

constexpr std::size_t ktx_header = 80, ktx_level_entry = 24;
constexpr std::uint32_t zstandard = 2;  // a scheme of supercompression

void append(KtxBytes& bytes, std::uint64_t number, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k, number >>= 8) bytes.push_back(std::uint8_t(number));
}

void append_all(KtxBytes& bytes, std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words) append(bytes, word, 4);
}

/// The texels of a file: their components, and whether they are compressed.
struct KtxTexels {
    std::size_t components;
    bool srgb, compressed;

    VkFormat format() const {
        if (components == 1) return vk_r8_unorm;
        return srgb ? vk_r8g8b8a8_srgb : vk_r8g8b8a8_unorm;
    }
};

/// The data format descriptor: model RGBSDA, primaries of BT.709, straight alpha, and a sample of 8
/// bits per component. The size of a texel is 0 in compressed data, as the specification asks.
KtxBytes descriptor(const KtxTexels& texels) {
    constexpr std::uint32_t model = 1, primaries = 1, linear = 1, srgb = 2, version = 2;
    constexpr std::uint32_t alpha = 15, is_linear = 0x10;
    const auto samples = std::uint32_t(texels.components), block = 24 + 16 * samples;
    KtxBytes bytes;
    append_all(bytes, {4 + block, 0, version | block << 16,
                       model | primaries << 8 | (texels.srgb ? srgb : linear) << 16, 0,
                       texels.compressed ? 0 : samples, 0});
    for (std::uint32_t c = 0; c < samples; ++c) {
        const std::uint32_t channel = c < 3         ? c
                                      : texels.srgb ? alpha | is_linear
                                                    : alpha;  // alpha is never sRGB-encoded
        append_all(bytes, {8 * c | 7u << 16 | channel << 24, 0, 0, 255});
    }
    return bytes;
}

/// The keys, in their order: how rows and columns run, and who has written the file.
KtxBytes key_values() {
    KtxBytes bytes;
    for (const std::string& text : {std::string("KTXorientation\0rd\0", 18),
                                    std::string("KTXwriter\0Burl " BURL_VERSION "\0",
                                                sizeof "KTXwriter\0Burl " BURL_VERSION)}) {
        append(bytes, text.size(), 4);
        bytes.insert(bytes.end(), text.begin(), text.end());
        bytes.resize((bytes.size() + 3) / 4 * 4);
    }
    return bytes;
}

/// The texels of a level as the file has them before compression: RGB gets an alpha of 255.
KtxBytes texels_of(const CodeRaster& level) {
    const std::size_t count = level.width * level.height;
    if (level.components != 3) return {level.pixels, level.pixels + level.components * count};
    KtxBytes bytes(4 * count, 255);
    for (std::size_t i = 0; i < count; ++i)
        std::copy_n(level.pixels + 3 * i, 3, bytes.data() + 4 * i);
    return bytes;
}

KtxBytes compressed(const KtxBytes& bytes, int level) {
    KtxBytes out(::ZSTD_compressBound(bytes.size()));
    const std::size_t size =
        ::ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), level);
    if (::ZSTD_isError(size))
        throw Error(ExitCode::runtime, fmt::format("the KTX2 level could not be compressed: {}",
                                                   ::ZSTD_getErrorName(size)));
    out.resize(size);
    out.shrink_to_fit();
    return out;
}

/// A level's bytes in the file, and its place there.
struct KtxLevel {
    KtxBytes bytes;
    std::uint64_t begin = 0, unpacked = 0;
};

/// Gives every level its place from `end` on, the last level first; levels that are not compressed
/// begin at multiples of 4, and so do all their texels.
void place(std::vector<KtxLevel>& levels, std::uint64_t end, bool aligned) {
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
        level->begin = aligned ? (end + 3) / 4 * 4 : end;
        end = level->begin + level->bytes.size();
    }
}

KtxBytes head_of(const CodeRaster& first, const std::vector<KtxLevel>& levels,
                 const KtxTexels& texels, const KtxBytes& about, const KtxBytes& keys) {
    constexpr std::array<std::uint8_t, 12> identifier{0xab, 'K',  'T',  'X',  ' ',  '2',
                                                      '0',  0xbb, '\r', '\n', 0x1a, '\n'};
    const auto about_begin = std::uint32_t(ktx_header + ktx_level_entry * levels.size());
    KtxBytes head(identifier.begin(), identifier.end());
    append_all(head, {texels.format(), 1, std::uint32_t(first.width), std::uint32_t(first.height),
                      0, 0, 1, std::uint32_t(levels.size()), texels.compressed ? zstandard : 0,
                      about_begin, std::uint32_t(about.size()),
                      about_begin + std::uint32_t(about.size()), std::uint32_t(keys.size())});
    append(head, 0, 16);  // no global data
    for (const KtxLevel& level : levels) {
        append(head, level.begin, 8);
        append(head, level.bytes.size(), 8);
        append(head, level.unpacked, 8);
    }
    return head;
}

}  // namespace

void encode_ktx2(std::span<const CodeRaster> levels, const ByteSink& sink, int level,
                 PngContent content, TaskMeter* meter) {
    const std::size_t components = levels[0].components == 1 ? 1 : 4;
    const KtxTexels texels{components, components > 1 && content == PngContent::color, level > 0};
    std::vector<KtxLevel> stored;
    for (const CodeRaster& one : levels) {
        KtxBytes bytes = texels_of(one);
        const std::uint64_t size = bytes.size();
        stored.push_back({level > 0 ? compressed(bytes, level) : std::move(bytes), 0, size});
        if (meter) meter->add(one.stride() * one.height);
    }
    const KtxBytes about = descriptor(texels), keys = key_values();
    std::uint64_t end = ktx_header + ktx_level_entry * levels.size() + about.size() + keys.size();
    place(stored, end, level == 0);
    sink(head_of(levels[0], stored, texels, about, keys));
    sink(about);
    sink(keys);
    for (auto one = stored.rbegin(); one != stored.rend(); ++one) {
        constexpr std::array<std::uint8_t, 3> zeros{};
        if (one->begin > end) sink(std::span(zeros).first(one->begin - end));
        sink(one->bytes);
        end = one->begin + one->bytes.size();
    }
}

}  // namespace burl
