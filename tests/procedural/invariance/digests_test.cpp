// Digests of small bakes, the same in every build: by any compiler, at any level of optimisation,
// with sanitizers or without, for any instruction set. The tables are what the release build gave;
// whoever changes a layout or a texture on purpose writes the new ones, which a failure prints.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "procedural/noise/names.h"
#include "tests/procedural/invariance/made_bakes.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

/// FNV-1a of 64 bits (Fowler, Noll, Vo) over values without padding.
class Digest {
  public:
    template <class T>
    Digest& add(std::span<const T> values) {
        for (const std::byte b : std::as_bytes(values))
            sum_ = (sum_ ^ std::uint64_t(b)) * 0x100000001b3u;
        return *this;
    }
    template <class T>
    Digest& add(const std::vector<T>& values) {
        return add(std::span<const T>(values));
    }
    std::string text() const { return fmt::format("{:016x}", sum_); }

  private:
    std::uint64_t sum_ = 0xcbf29ce484222325u;
};

/// The digests of a bake's stages: places, solid points, texture, levels.
std::string digests_of(const MeshAtlas& atlas, const test::MadeBake& bake) {
    Digest places, points, texture, levels;
    places.add(atlas.atlas().corners).add(atlas.atlas().charts);
    points.add(test::shown_points(bake.solid));
    texture.add(bake.texture.pixels());
    for (const Image<RgbF>& level : bake.levels) levels.add(level.pixels());
    return fmt::format("{} {} {} {}", places.text(), points.text(), texture.text(), levels.text());
}

struct Expected {
    std::string_view name, digests;
};

constexpr Expected bakes[] = {
    {"uniform ball", "082c27ddf01c5cc7 b68bb01f96557729 a22684335c7b5aa9 391a15f2401841d0"},
    {"uniform box", "5f1005f528037027 d3ab09970f8e38e1 6eb032427afff3ed 6d935b27b7eb7b43"},
    {"area ball", "fe4a876db289e1ce ec751bd3aef922ee a7707920340973bb 30d559dbeadfbd6f"},
    {"area box", "199ff63f9bee01f8 7139aae1a4e558cd 97753bd14cf4f7c6 c8b6f144310ef7dd"},
    {"length ball", "a5f3cb11ea37523a 173d806005694a4a 7a196bfdbbe125ac 4f888a344f9c9aa2"},
    {"length box", "86a73a6472ec4abd 40d36c756faa65ef 2cdb3f67c724f10c 44de5445bb49c319"},
    {"quad ball", "163600584437c9b7 5755e5dd2e93b410 7e2cc2f6019b7fbb c65f4b82be63ed06"},
    {"quad box", "1f3538218535409d eab69004c07d2771 5d96e69469c3763d 04fae6609a042479"},
    {"patch ball", "772a16b7b5eed803 646511dd2e0eab3d 17d2d9d2fee7e0f8 92941c85339dcbad"},
    {"patch box", "278f254377d7191d 15a717e3c429e09d c4e7543a08ab41f8 17dc69bb4468a676"},
    {"chart ball", "9fa470818c6a8ddf 3e2757cca78e309d 3ea8566693a975a6 49c835b30cbebe81"},
    {"chart box", "3a1101992a4722c7 4e2c8fc20e4b680e 9ccb043da3ce4789 8ab3abd67a9e12f8"},
    {"uv ball", "ccf308aaf89774b6 a61829626acbd0b1 c07ab70effd29c9f 9f0d7ae2855cc942"},
    {"uv box", "93d7e41177e96797 8353f980092b78e6 7bf9806b5be5a848 8d36bdbb0462a758"},
};

/// Meshes whose points are made by square roots and divisions alone, which no library rounds.
TEST(Digests, OfBakesAreTheSameInEveryBuild) {
    std::string now;
    for (const AtlasKind kind :
         {AtlasKind::uniform, AtlasKind::area, AtlasKind::length, AtlasKind::quad, AtlasKind::patch,
          AtlasKind::chart, AtlasKind::uv})
        for (const auto& [name, mesh] :
             {made::Named{"ball", made::ball(3)}, made::Named{"box", made::box(4)}}) {
            const test::MadeBake bake =
                test::made_bake(kind == AtlasKind::uv ? test::with_own_places(mesh) : mesh, kind);
            const std::string full = fmt::format("{} {}", to_string(kind), name);
            const std::string digests = digests_of(bake.atlas, bake);
            now += fmt::format("    {{\"{}\", \"{}\"}},\n", full, digests);
            const auto* known = std::ranges::find(bakes, full, &Expected::name);
            EXPECT_TRUE(known != std::end(bakes) && known->digests == digests) << full;
        }
    if (HasFailure()) std::fputs(now.c_str(), stderr);
}

constexpr Expected textures[] = {
    {"kernel auto", "fd1d4e0d58b2524e"},       {"kernel direct", "fd1d4e0d58b2524e"},
    {"kernel share", "fd1d4e0d58b2524e"},      {"kernel scanline", "e996fac31b372ec6"},
    {"filter none", "fd1d4e0d58b2524e"},       {"filter table-mip", "b9afedee1c7d9d61"},
    {"filter table-sat", "c46833ac2fbed408"},  {"filter table-sat3", "c46833ac2fbed408"},
    {"filter exact", "38ff7849345ea87f"},      {"filter trapezoid", "53fde284f61c3281"},
    {"filter trapezoid2", "7cfdf8ee637e2d99"}, {"filter supersample", "d719583b8ea8cbb9"},
    {"noise value", "b19356ff906b3327"},       {"noise perlin", "4ced95b871c2279d"},
    {"noise perlin2002", "51e9dc9054511406"},  {"noise perlin1985", "6c47eece523c7586"},
    {"noise simplex", "b79fd527bd439e88"},     {"noise worley", "51dc232367ef165b"},
    {"noise cell", "a4d3ab87452b1f84"},        {"noise white", "1ed40ab09a944dae"},
};

TEST(Digests, OfTexturesAreTheSameInEveryBuild) {
    const SolidAtlas solid = SyntheticAtlas{.size = 96, .block = 31, .step = 0.03}.make(5);
    const Affine3 same{Mat3d(1.0), Vec3d(0.0)};
    std::string now;
    const auto check = [&](const std::string& name, const auto& image) {
        const std::string digest = Digest().add(image.pixels()).text();
        now += fmt::format("    {{\"{}\", \"{}\"}},\n", name, digest);
        const auto* known = std::ranges::find(textures, name, &Expected::name);
        EXPECT_TRUE(known != std::end(textures) && known->digests == digest) << name;
    };
    Texture texture = test::marble_with_perlin();
    for (const auto& [name, kernel] : kernel_names)
        check(fmt::format("kernel {}", name),
              synthesize_model<RgbF>(solid, texture, same, 0, {}, kernel));
    for (std::size_t k = 0; k < enum_names<FilterKind>.size(); ++k)
        check(fmt::format("filter {}", enum_names<FilterKind>[k]),
              synthesize_model<RgbF>(solid, texture, same, 0, {.kind = FilterKind(k)}));
    for (const auto& noise : noise_kinds) {
        texture.noise.resize(1);
        texture.noise[0].kind = noise.value;
        check(fmt::format("noise {}", noise.name), synthesize_model<RgbF>(solid, texture, same, 0));
    }
    if (HasFailure()) std::fputs(now.c_str(), stderr);
}

}  // namespace
}  // namespace burl
