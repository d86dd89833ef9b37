// What must not change a file's bytes, for every kind of atlas: docs/reference/invariance.md.
#include <algorithm>
#include <map>

#include "app/image/image_io.h"
#include "tests/app/programs/run_program.h"
#include "tests/procedural/invariance/made_bakes.h"

namespace burl::test {
namespace {

constexpr const char* baked_kinds[] = {"uniform", "area", "length", "quad", "patch", "chart", "uv"};

/// The mesh as an OBJ file with points[i] in line order[i], times `scale`.
std::string obj_text(const Mesh& mesh, const std::vector<std::uint32_t>& order, double scale) {
    std::vector<Vec3d> points(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) points[order[i]] = scale * mesh.positions[i];
    std::string text;
    for (const Vec3d& p : points) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (const Vec2d& q : mesh.corners.uvs) text += fmt::format("vt {} {}\n", q.x, q.y);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        text += "f";
        for (std::size_t k = 0; k < 3; ++k)
            text += fmt::format(" {}/{}", order[mesh.triangles[t][k]] + 1, 3 * t + k + 1);
        text += "\n";
    }
    return text;
}

/// A folder with one mesh in several files, all called mesh.obj.
class InvariantFiles : public testing::Test {
  protected:
    const Scratch scratch;
    const Mesh mesh = with_own_places(made::ball(2));

    InvariantFiles() {
        std::vector<std::uint32_t> order(mesh.positions.size());
        std::iota(order.begin(), order.end(), 0u);
        write("plain", obj_text(mesh, order, 1.0));
        write("small", obj_text(mesh, order, 0x1p-10));
        std::reverse(order.begin(), order.end());
        write("reversed", obj_text(mesh, order, 1.0));
    }
    void write(const std::string& folder, const std::string& text) const {
        fs::create_directories(scratch / folder);
        std::ofstream(scratch / folder + "/mesh.obj") << text;
    }
    /// The bytes of a bake of that folder's mesh with levels.
    std::string bake(const std::string& folder, const std::string& options,
                     const std::string& extension = "glb", const std::string& prefix = "") const {
        const std::string out = scratch / ("baked." + extension);
        const Outcome outcome =
            run_burl(scratch,
                     fmt::format("bake '{}/mesh.obj' -o '{}' --size 64 --no-skip up-to-date {}",
                                 scratch / folder, out, options),
                     prefix);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return slurp(out);
    }
};

TEST_F(InvariantFiles, DependNeitherOnTheOrderOfPointsNorOnThreadsSkipsAndLanguage) {
    for (const std::string kind : baked_kinds) {
        SCOPED_TRACE(kind);
        const std::string options = "--atlas " + kind;
        const std::string bytes = bake("plain", options);
        ASSERT_GT(bytes.size(), 10000u);
        EXPECT_EQ(bake("reversed", options), bytes);
        EXPECT_EQ(bake("plain", options + " -j 1"), bytes);
        EXPECT_EQ(bake("plain", options + " -j 5"), bytes);
        EXPECT_EQ(bake("plain", options + " --no-skip all"), bytes);
        EXPECT_EQ(bake("plain", options, "glb", "LC_ALL=de_DE.UTF-8 LANGUAGE=de TZ=Asia/Tokyo"),
                  bytes);
        EXPECT_EQ(bake("plain", options + " --kernel direct"),
                  bake("plain", options + " --kernel share"));
    }
}

TEST_F(InvariantFiles, OfPicturesDoNotDependOnScalesByPowersOfTwo) {
    for (const std::string kind : baked_kinds)
        for (const std::string extension : {"png", "exr"}) {
            const std::string options = "--atlas " + kind;
            EXPECT_EQ(bake("small", options, extension), bake("plain", options, extension)) << kind;
        }
}

TEST_F(InvariantFiles, AreThoseOfABatch) {
    std::string bakes;
    for (const std::string kind : baked_kinds)
        bakes += fmt::format(R"({}{{"mesh": "{}", "atlas": "{}", "size": 64, "output": "{}"}})",
                             bakes.empty() ? "" : ", ", scratch / "plain/mesh.obj", kind,
                             scratch / (kind + ".glb"));
    const std::string manifest = scratch.write("m.json", "{\"bakes\": [" + bakes + "]}");
    for (const int jobs : {1, 4}) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("batch '{}' --force --jobs {}", manifest, jobs));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        for (const std::string kind : baked_kinds)
            EXPECT_EQ(slurp(scratch / (kind + ".glb")), bake("plain", "--atlas " + kind)) << kind;
    }
}

TEST_F(InvariantFiles, OfKernelsDifferByOneCodeAtMost) {
    for (const std::string kind : baked_kinds) {
        const auto picture = [&](const std::string& kernel) {
            bake("plain", fmt::format("--atlas {} --kernel {}", kind, kernel), "png");
            return read_png(scratch / "baked.png");
        };
        const Image<Rgb8> scanned = picture("scanline"), direct = picture("direct");
        ASSERT_EQ(scanned.pixels().size(), direct.pixels().size());
        int most = 0;
        for (std::size_t i = 0; i < scanned.pixels().size(); ++i) {
            const Rgb8 &a = scanned.pixels()[i], &b = direct.pixels()[i];
            most = std::max({most, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        }
        EXPECT_LE(most, 1) << kind;
    }
}

}  // namespace
}  // namespace burl::test
