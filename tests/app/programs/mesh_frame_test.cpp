// Axes and units as the command line has them: a z-up file in millimetres and its y-up twin in
// metres.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "atlas/base/json.h"
#include "atlas/read/read_mesh.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using test::Outcome;
using test::run_burl;
using test::Scratch;
using test::slurp;

/// A bent tube of quads, open at its ends, of which no two directions are alike; `twin`: y-up, in
/// metres.
std::string tube(bool twin, double bend = 0.0) {
    constexpr int around = 12, along = 9;
    std::string text;
    for (int i = 0; i <= along; ++i)
        for (int k = 0; k < around; ++k) {
            const double angle = 2.0 * std::acos(-1.0) * k / around;
            const Vec3d p(30.0 * std::cos(angle) + bend * i * i, 20.0 * std::sin(angle) + 3.0 * i,
                          40.0 * i);
            const Vec3d q = twin ? Vec3d(p.x, p.z, -p.y) / 1000.0 : p;
            text += fmt::format("v {} {} {}\n", q.x, q.y, q.z);
        }
    for (int i = 0; i < along; ++i)
        for (int k = 0; k < around; ++k) {
            const int a = i * around + k + 1, b = i * around + (k + 1) % around + 1;
            text += fmt::format("f {} {} {} {}\n", a, b, b + around, a + around);
        }
    return text;
}

struct MeshFrameOfFiles : testing::Test {
    MeshFrameOfFiles() {
        scratch.write("scan.obj", tube(false));
        scratch.write("twin.obj", tube(true));
    }
    /// Runs `VERB SCAN --up z --units mm REST` and `VERB TWIN REST`, in folders of their own.
    void both(const std::string& verb, const std::string& rest) const {
        for (const std::string name : {"scan", "twin"}) {
            fs_create(name);
            const std::string frame = name == "scan" ? "--up z --units mm" : "";
            const Outcome ran =
                run_burl(scratch, fmt::format("{} ../{}.obj {} {}", verb, name, frame, rest),
                         fmt::format("cd '{}' &&", scratch / name));
            ASSERT_EQ(ran.exit_code, 0) << ran.err;
        }
    }
    void fs_create(const std::string& name) const {
        std::filesystem::create_directories(scratch.path() / name);
    }
    std::string of_scan(const std::string& file) const { return slurp(scratch / ("scan/" + file)); }
    std::string of_twin(const std::string& file) const { return slurp(scratch / ("twin/" + file)); }
    const Scratch scratch;
};

TEST_F(MeshFrameOfFiles, GiveTheTexturesOfTheTwin) {
    for (const char* recipe : {"marble", "oak --set size=0.36"}) {
        both("bake", fmt::format("-o a.png --size 256 -q --recipe {}", recipe));
        ASSERT_GT(of_scan("a.png").size(), 1000u);
        EXPECT_EQ(of_scan("a.png"), of_twin("a.png")) << recipe;
    }
    const Outcome lying =
        run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 256 -q", scratch / "scan.obj",
                                      scratch / "lying.png"));
    ASSERT_EQ(lying.exit_code, 0);
    EXPECT_NE(slurp(scratch / "lying.png"), of_twin("a.png"));
}

TEST_F(MeshFrameOfFiles, GiveTheScenesOfTheTwin) {
    for (const char* file : {"a.obj", "a.glb"}) {
        both("bake", fmt::format("-o {} --size 128 -q", file));
        const Mesh scan = read_mesh(scratch / fmt::format("scan/{}", file));
        const Mesh twin = read_mesh(scratch / fmt::format("twin/{}", file));
        EXPECT_EQ(scan.positions, twin.positions);
        EXPECT_EQ(scan.triangles, twin.triangles);
        EXPECT_EQ(scan.corners.uvs, twin.corners.uvs);
        EXPECT_NEAR(bounding_box(scan).size().y, 0.36, 1e-7);
    }
}

TEST_F(MeshFrameOfFiles, GiveThePicturesAndFiguresOfTheTwin) {
    both("render", "--direct --recipe agate --set size=0.36 --rays 8 --size 96x96 -o p.png");
    ASSERT_GT(of_scan("p.png").size(), 1000u);
    EXPECT_EQ(of_scan("p.png"), of_twin("p.png"));
    both("render", "--lazy --recipe agate --set size=0.36 --size 96x96 -o l.png");
    EXPECT_EQ(of_scan("l.png"), of_twin("l.png"));
}

TEST_F(MeshFrameOfFiles, TakePosesAlong) {
    scratch.write("bent-scan.obj", tube(false, 0.7));
    scratch.write("bent-twin.obj", tube(true, 0.7));
    for (const std::string name : {"scan", "twin"}) {
        fs_create(name);
        const Outcome ran =
            run_burl(scratch,
                     fmt::format("bake ../{0}.obj --pose ../bent-{0}.obj {1} -o a.obj -q", name,
                                 name == "scan" ? "--up z --units mm" : ""),
                     fmt::format("cd '{}' &&", scratch / name));
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
    }
    EXPECT_EQ(read_mesh(scratch / "scan/a.obj").positions,
              read_mesh(scratch / "twin/a.obj").positions);
}

TEST_F(MeshFrameOfFiles, GiveMaterialsTheMeshsOwnSize) {
    const auto size = [&](const std::string& options, const std::string& recipe = "oak") {
        const Outcome ran = run_burl(
            scratch, fmt::format("bake '{}' -o '{}' --size 128 --recipe {} --json {}",
                                 scratch / "scan.obj", scratch / "s.png", recipe, options));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return nlohmann::json::parse(ran.out)["recipe"]["solid"]["scale"].get<double>();
    };
    EXPECT_EQ(size(""), 0.3);
    EXPECT_EQ(size("--units mm"), 0.36);
    EXPECT_EQ(size("--units cm"), 3.6);
    EXPECT_EQ(size("--units m"), 20.0);  // the control's greatest
    EXPECT_EQ(size("--units mm --set size=2"), 2.0);
    EXPECT_EQ(size("--units mm --set Size=2"), 2.0);
    EXPECT_EQ(size("--units mm --set solid.scale=2"), 2.0);
    EXPECT_EQ(size("--units m --scale 1000", "living-planet"), 360.0);  // kilometres
}

TEST_F(MeshFrameOfFiles, AreBakedAgainInAnotherFrame) {
    const auto status = [&](const std::string& options) {
        const Outcome ran =
            run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 64 --json {}",
                                          scratch / "scan.obj", scratch / "u.obj", options));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return nlohmann::json::parse(ran.out).contains("up_to_date");
    };
    EXPECT_FALSE(status("--up z"));
    EXPECT_TRUE(status("--up z"));
    EXPECT_FALSE(status("--up -z"));
    EXPECT_FALSE(status("--up -z --rotate 0,10,0"));
    EXPECT_FALSE(status("--up -z --rotate 0,10,0 --scale 2"));
    EXPECT_FALSE(status("--up -z --rotate 0,10,0 --scale 2 --units cm"));
    EXPECT_TRUE(status("--up -z --rotate 0,10,0 --scale 2 --units cm"));
}

TEST_F(MeshFrameOfFiles, AreEachTheirOwnInABatch) {
    scratch.write("batch.json", R"({"bakes": [
        {"mesh": "scan.obj", "output": "b1.obj", "size": 64, "up": "z", "units": "mm"},
        {"mesh": "scan.obj", "output": "b2.obj", "size": 64}]})");
    const Outcome ran = run_burl(scratch, fmt::format("batch '{}'", scratch / "batch.json"));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(bounding_box(read_mesh(scratch / "b1.obj")).size().y, 0.36);
    EXPECT_EQ(bounding_box(read_mesh(scratch / "b2.obj")).size().z, 360.0);
}

TEST_F(MeshFrameOfFiles, RefuseWhatHasNoMeaning) {
    const auto refused = [&](const std::string& command) {
        const Outcome ran =
            run_burl(scratch, command, fmt::format("cd '{}' &&", scratch.path().string()));
        EXPECT_EQ(ran.exit_code, 1) << command;
        return ran.err;
    };
    for (const char* wrong :
         {"--rotate 1,2", "--rotate 1,2,3,4", "--rotate 1,2,x", "--rotate nan,0,0",
          "--rotate 0,0,361", "--units inch", "--scale 0", "--scale -1", "--up w"})
        EXPECT_NE(refused(fmt::format("bake scan.obj -o a.png {}", wrong)), "") << wrong;
    EXPECT_NE(refused("render scan.obj -o a.png --units mm").find("--units"), std::string::npos);
    EXPECT_NE(refused("eval marble --points p.csv --up z").find("--mesh"), std::string::npos);
}

}  // namespace
}  // namespace burl
