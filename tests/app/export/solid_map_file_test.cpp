// Solid maps as files, read back by the OpenEXR library itself.
#include "app/export/emit.h"

#include <cmath>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfVecAttribute.h>
#include <gmock/gmock.h>

#include "app/pipeline/pipeline.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/batch/point_map.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using test::Outcome;
using test::run_burl;
using test::Scratch;
using testing::HasSubstr;

struct ReadMap {
    SolidMap map;
    Imath::V3d base;
};

ReadMap read_back(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const auto width = std::size_t(window.max.x + 1), height = std::size_t(window.max.y + 1);
    ReadMap result{{Image<Vec4f>(width, height), Image<std::uint32_t>(width, height)},
                   file.header().typedAttribute<Imf::V3dAttribute>("base").value()};
    Imf::FrameBuffer frame;
    auto* local = reinterpret_cast<char*>(&result.map.local(0, 0));
    const char* names[] = {"X", "Y", "Z", "A"};
    for (std::size_t c = 0; c < 4; ++c)
        frame.insert(names[c], Imf::Slice(Imf::FLOAT, local + 4 * c, 16, 16 * width));
    frame.insert("owner", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(&result.map.owners(0, 0)),
                                     4, 4 * width));
    file.setFrameBuffer(frame);
    file.readPixels(0, int(height) - 1);
    return result;
}

TEST(SolidMapFile, HoldsThePointsOfTheBakedAtlas) {
    const Scratch scratch;
    const std::string arguments = "bake sample:torus -o '" + scratch / "t.png" +
                                  "' -s 128 --set solid.scale=3 --quiet " + "--solid-map '" +
                                  scratch / "t.exr" + "' --report '" + scratch / "t.json" + "'";
    const Outcome outcome = run_burl(scratch, arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const ReadMap read = read_back(scratch / "t.exr");
    const auto report = nlohmann::json::parse(test::slurp(scratch / "t.json"));
    EXPECT_EQ(report["solid_map"]["base"][1].get<double>(), read.base.y);
    EXPECT_EQ(report["outputs"].back().get<std::string>(), scratch / "t.exr");

    Pipeline pipeline(sample_mesh("sample:torus"));
    Recipe recipe;
    recipe.atlas.size = 128;
    pipeline.set_recipe(recipe);
    const SolidAtlas& solid = pipeline.solid();
    ASSERT_EQ(read.map.owners.width(), 128u);
    std::size_t owned = 0, claimed = 0;
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                const Vec3d p = 3.0 * solid.maps[span.map](std::int64_t(x), std::int64_t(y));
                const Vec4f& texel = read.map.local(x, y);
                ASSERT_NEAR(read.base.x + double(texel.x), p.x, 3e-7);
                ASSERT_NEAR(read.base.y + double(texel.y), p.y, 3e-7);
                ASSERT_NEAR(read.base.z + double(texel.z), p.z, 3e-7);
                ASSERT_EQ(texel.w, 1.0f);
                ASSERT_EQ(read.map.owners(x, y), span.map);
                ++owned;
            }
    for (const std::uint32_t owner : read.map.owners.pixels()) claimed += owner != no_owner;
    EXPECT_EQ(owned, claimed);
}

TEST(SolidMapFile, RefusesNamesItCannotWrite) {
    const Scratch scratch;
    const std::string bake = "bake sample:cube -o '" + scratch / "t.exr" + "' -s 64 --solid-map '";
    const Outcome png = run_burl(scratch, bake + scratch / "t.png'");
    EXPECT_EQ(png.exit_code, int(ExitCode::usage));
    EXPECT_THAT(png.err, HasSubstr(".exr"));
    const Outcome same = run_burl(scratch, bake + scratch / "t.exr'");
    EXPECT_EQ(same.exit_code, int(ExitCode::io));
    EXPECT_EQ(scratch.files(), 0u);
}

}  // namespace
}  // namespace burl
