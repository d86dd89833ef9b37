#include "app/bake/compress.h"

#include <nlohmann/json.hpp>

#include "atlas/base/error.h"

namespace burl {

namespace {

std::uint64_t texel_bytes(const BakedImage& image) {
    return std::visit([](const auto& i) { return std::uint64_t{sizeof(i(0, 0))}; }, image);
}

}  // namespace

void check_compress(const std::optional<double>& most_error, AtlasKind kind) {
    if (!most_error || kind == AtlasKind::quad) return;
    throw Error(ExitCode::usage,
                fmt::format("--compress: only blocks of the quad atlas can share a place, this one "
                            "is {}; use --atlas quad",
                            to_string(kind)));
}

BakedAtlas compressed_bake(const Atlas& atlas, BakedImage image,
                           const std::optional<double>& most_error) {
    if (!most_error) return {std::nullopt, std::move(image), std::nullopt};
    return std::visit(
        [&](const auto& picture) {
            auto result = compress_blocks(atlas, picture, *most_error);
            return BakedAtlas{std::move(result.atlas), std::move(result.image), result.notes};
        },
        image);
}

Json compress_json(const BakedAtlas& baked) {
    const CompressNotes& notes = *baked.compressed;
    const std::uint64_t bytes = texel_bytes(baked.image);
    const Vec2d extent = baked.packed->extent();
    return {{"width", std::uint64_t(extent.x)},
            {"height", std::uint64_t(extent.y)},
            {"blocks", notes.blocks},
            {"places", notes.places},
            {"texels_before", notes.texels_before},
            {"texels_after", notes.texels_after},
            {"bytes_before", bytes * notes.texels_before},
            {"bytes_after", bytes * notes.texels_after},
            {"largest_error", notes.largest_error}};
}

void print_compressed(const Json& compressed) {
    fmt::print(
        "compressed to {} x {}: {} of {} blocks kept, {:.1f} % of the texels and bytes saved, "
        "largest error {:.4f}\n",
        compressed["width"].get<std::uint64_t>(), compressed["height"].get<std::uint64_t>(),
        compressed["places"].get<std::uint64_t>(), compressed["blocks"].get<std::uint64_t>(),
        100.0 * (1.0 - compressed["texels_after"].get<double>() /
                           compressed["texels_before"].get<double>()),
        compressed["largest_error"].get<double>());
}

}  // namespace burl
