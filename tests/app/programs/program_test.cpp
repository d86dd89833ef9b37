// The program as its user meets it: a bake that works and says what it did.

#include "app/image/image_io.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

const char* const program_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

TEST(Program, BakesEveryOutputKind) {
    const Scratch scratch;
    const std::string mesh = scratch.write("square.obj", program_square);
    for (const char* name : {"a.glb", "b.gltf", "c.obj", "d.png", "e.exr"}) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 64", mesh, scratch / name));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_TRUE(fs::exists(scratch / name)) << name;
        EXPECT_NE(outcome.out.find("coverage"), std::string::npos) << outcome.out;
    }
    for (const char* beside : {"b.png", "c.mtl", "c.png"})
        EXPECT_TRUE(fs::exists(scratch / beside)) << beside;
}

TEST(Program, WritesLevelsBesideOrIntoTheTexture) {
    const Scratch scratch;
    const std::string mesh = scratch.write("square.obj", program_square);
    const auto bake = [&](const std::string& arguments) {
        return run_burl(scratch, fmt::format("bake '{}' --size 64 {}", mesh, arguments));
    };
    const Outcome some = bake(fmt::format("--levels 2 --json -o '{}'", scratch / "a.png"));
    ASSERT_EQ(some.exit_code, 0) << some.err;
    EXPECT_EQ(nlohmann::json::parse(some.out)["outputs"].size(), 3u);
    EXPECT_EQ(read_png(scratch / "a.1.png").width(), 32u);
    EXPECT_EQ(read_png(scratch / "a.2.png").height(), 16u);
    EXPECT_FALSE(fs::exists(scratch / "a.3.png"));
    ASSERT_EQ(bake(fmt::format("--levels all -o '{}'", scratch / "b.obj")).exit_code, 0);
    EXPECT_EQ(read_png(scratch / "b.6.png").width(), 1u);
    ASSERT_EQ(bake(fmt::format("--levels 99 -o '{}'", scratch / "c.gltf")).exit_code, 0);
    EXPECT_TRUE(fs::exists(scratch / "c.6.png"));
    ASSERT_EQ(bake(fmt::format("--levels 1 -o '{}'", scratch / "d.exr")).exit_code, 0);
    const Outcome strips =
        bake(fmt::format("--levels all --atlas uniform -o '{}'", scratch / "e.png"));
    EXPECT_EQ(strips.exit_code, 0);
    EXPECT_NE(strips.err.find("quad"), std::string::npos) << strips.err;
    EXPECT_EQ(bake(fmt::format("--levels many -o '{}'", scratch / "f.png")).exit_code, 1);
    EXPECT_FALSE(fs::exists(scratch / "f.png"));
}

TEST(Program, TextureIsExactlyAsLargeAsAskedAndNotFlat) {
    const Scratch scratch;
    const std::string mesh = scratch.write("square.obj", program_square), png = scratch / "t.png";
    ASSERT_EQ(run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 100", mesh, png)).exit_code,
              0);
    const Image<Rgb8> image = read_png(png);
    EXPECT_EQ(image.width(), 100u);
    EXPECT_EQ(image.height(), 100u);
    int low = 255, high = 0;
    for (const Rgb8& pixel : image.pixels()) {
        low = std::min<int>(low, pixel.g);
        high = std::max<int>(high, pixel.g);
    }
    EXPECT_GT(high - low, 60);
}

TEST(Program, SameBytesForEveryThreadCount) {
    const Scratch scratch;
    const std::string mesh = scratch.write("square.obj", program_square);
    for (const int threads : {1, 2, 5}) {
        const std::string png = scratch / fmt::format("{}.png", threads);
        ASSERT_EQ(
            run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 128 -j {}", mesh, png, threads))
                .exit_code,
            0);
        EXPECT_EQ(slurp(png), slurp(scratch / "1.png")) << threads;
    }
}

TEST(Program, ReportIsJson) {
    const Scratch scratch;
    const std::string mesh = scratch.write("square.obj", program_square), glb = scratch / "s.glb";
    const Outcome outcome =
        run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 64 --json", mesh, glb));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["mesh"]["triangles"], 2);
    EXPECT_EQ(report["atlas"]["size"], 64);
    EXPECT_EQ(report["outputs"][0], glb);
    EXPECT_EQ(report["atlas"]["kind"], "chart");
    EXPECT_EQ(report["atlas"]["charts"], 1);
    EXPECT_GT(report["atlas"]["coverage"].get<double>(), 0.4);
}

TEST(Program, JsonIsAllThatItPrints) {
    const Scratch scratch;
    for (const char* command : {"bake '{}' -o '{}' --size 64 --json", "metrics '{}' --json"}) {
        const Outcome outcome = run_burl(
            scratch, fmt::format(fmt::runtime(command), case_file("metis.obj"), scratch / "a.glb"));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << outcome.out.substr(0, 200);
    }
}

TEST(Program, MeasuresTheUvsAFileBrings) {
    const Scratch scratch;
    const auto quoted = [](const std::string& path) { return "'" + path + "'"; };
    const std::string plain = quoted(scratch.write("plain.obj", program_square));
    const std::string mesh = quoted(scratch.write(
        "uv.obj", std::string(program_square).substr(0, std::string(program_square).find('f')) +
                      "vt 0 0\nvt .5 0\nvt .5 .5\nvt 0 .5\nf 1/1 2/2 3/3 4/4\n"));
    const auto kinds = [&](const std::string& arguments) {
        const Outcome outcome = run_burl(scratch, "metrics --json --size 32 " + arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        std::string names;
        const auto report = nlohmann::json::parse(outcome.out);
        for (const auto& row : report["atlases"]) names += row["kind"].get<std::string>() + " ";
        return names;
    };
    EXPECT_EQ(kinds(plain), "chart ");
    EXPECT_EQ(kinds(mesh), "uv ");
    EXPECT_EQ(kinds(mesh + " --atlas all"), "uniform area length quad patch chart ");
    EXPECT_EQ(kinds(mesh + " --atlas area --uv"), "uv area ");
    EXPECT_EQ(run_burl(scratch, "metrics --uv " + plain).exit_code, 1);
    // Before anything is measured, which would take longer than a test may.
    const Outcome without = run_burl(scratch, "metrics --uv --levels --size 16384 sample:teapot");
    EXPECT_EQ(without.exit_code, 1);
    EXPECT_NE(without.err.find("has no texture coordinates"), std::string::npos) << without.err;
    const Outcome nowhere = run_burl(
        scratch,
        fmt::format("metrics --levels -s 16384 sample:teapot --image '{}'", scratch / "no/x"));
    EXPECT_EQ(nowhere.exit_code, 2) << nowhere.err;
    expect_one_sentence(nowhere.err);
    const Outcome table = run_burl(scratch, "metrics --size 32 " + mesh);
    EXPECT_NE(table.out.find("0.2500"), std::string::npos) << table.out;
}

TEST(Program, MeasuresLookupsOfEveryLevel) {
    const Scratch scratch;
    const std::string mesh = scratch.write("square.obj", program_square);
    const Outcome outcome =
        run_burl(scratch, fmt::format("metrics '{}' --size 64 --levels --json", mesh));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto lookups = nlohmann::json::parse(outcome.out)["atlases"][0]["lookups"];
    EXPECT_GT(lookups["psnr"].get<double>(), 25.0);
    ASSERT_EQ(lookups["levels"].size(), 7u);
    double before = 0.0;
    for (const auto& level : lookups["levels"]) {
        EXPECT_LT(level["truth_noise"].get<double>(), 0.01);
        if (level["level"].get<int>() <= 4) {
            EXPECT_GT(level["rmse"].get<double>(), 0.5 * before);
        }
        before = level["rmse"].get<double>();
    }
    const auto& grazing = lookups["grazing_8_to_1"];
    ASSERT_EQ(grazing.size(), 1u);  // further levels have less than 32 texels a side
    EXPECT_EQ(grazing[0]["level"], 1);
    EXPECT_GT(grazing[0]["rmse"], 0.0);
    EXPECT_NE(grazing[0]["rmse_8bit"], grazing[0]["rmse"]);
    EXPECT_LT(grazing[0]["truth_noise"], 0.01);
    const auto& views = lookups["sampled_views"];
    ASSERT_EQ(views.size(), 25u);
    EXPECT_EQ(views[8]["minification"], 2.0);
    EXPECT_EQ(views[8]["tilt"], 75.0);
    for (const auto& view : views) {
        ASSERT_EQ(view["rmse"].size(), 6u);
        EXPECT_GT(view["rmse"]["16x"], view["truth_noise"]);
    }
    EXPECT_GT(views[8]["rmse"]["trilinear"], 1.5 * views[8]["rmse"]["16x"].get<double>());
    const Outcome table = run_burl(scratch, fmt::format("metrics '{}' --size 8 --levels", mesh));
    EXPECT_NE(table.out.find("16x ellipse"), std::string::npos);
    EXPECT_NE(table.out.find("\n16:1      85 "), std::string::npos) << table.out;
}

TEST(Program, MeasuresLookupsOfAnyTexture) {
    const Scratch scratch;
    const std::string mesh = scratch.write("square.obj", program_square);
    // Grey grows with height alone: bilinear lookups and levels are all but exact.
    const std::string recipe =
        scratch.write("ramp.json",
                      R"({"name": "ramp", "texture": {"node": "color_map", "wrap": "clamp",
            "stops": [[0, "#000000"], [1, "#ffffff"]],
            "input": {"node": "field", "quadric": {"G": 0.25, "J": 0.5}}}})");
    const auto lookups = [&](const std::string& arguments) {
        const Outcome outcome = run_burl(
            scratch, fmt::format("metrics '{}' --size 4 --atlas uniform --levels --json {}", mesh,
                                 arguments));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return nlohmann::json::parse(outcome.out)["atlases"][0]["lookups"];
    };
    const auto ramp = lookups(fmt::format("--recipe '{}'", recipe)), plain = lookups("");
    EXPECT_EQ(ramp["texture"], "ramp");
    EXPECT_EQ(plain["texture"], "metric-marble");
    EXPECT_GT(ramp["psnr"].get<double>(), 100.0);
    EXPECT_LT(plain["psnr"].get<double>(), 40.0);
    EXPECT_TRUE(plain["grazing_8_to_1"].empty());
    EXPECT_EQ(run_burl(scratch, fmt::format("metrics '{}' --texture wood", mesh)).exit_code, 1);
    EXPECT_EQ(run_burl(scratch, fmt::format("metrics '{}' --fill pink", mesh)).exit_code, 1);
}

TEST(Program, DrawsPicturesOfWhatItMeasures) {
    const Scratch scratch;
    const std::string mesh = scratch.write("square.obj", program_square);
    const Outcome outcome = run_burl(
        scratch, fmt::format("metrics '{}' --size 32 --json --image '{}'", mesh, scratch / "s"));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto images = nlohmann::json::parse(outcome.out)["atlases"][0]["images"];
    ASSERT_EQ(images.size(), 3u);
    for (const char* topic : {"charts", "scale", "levels"})
        EXPECT_GT(read_png(scratch / fmt::format("s-chart-{}.png", topic)).width(), 256u);
    const Outcome nowhere = run_burl(
        scratch, fmt::format("metrics '{}' --size 32 --image '{}'", mesh, scratch / "no/s"));
    EXPECT_EQ(nowhere.exit_code, 2);
    expect_one_sentence(nowhere.err);
}

TEST(Program, HelpVersionAndLists) {
    const Scratch scratch;
    for (const char* verb : {"", "bake", "render", "diff", "metrics", "bench", "eval", "list"}) {
        const Outcome outcome = run_burl(scratch, fmt::format("{} --help", verb));
        EXPECT_EQ(outcome.exit_code, 0) << verb;
        EXPECT_NE(outcome.out.find("--help"), std::string::npos) << verb;
    }
    const Outcome version = run_burl(scratch, "--version");
    for (const char* name : {"burl 0.", "OpenMesh 9", "Highway", "simd "}) {
        EXPECT_NE(version.out.find(name), std::string::npos) << version.out;
    }
    EXPECT_NE(run_burl(scratch, "list recipes").out.find("marble"), std::string::npos);
    EXPECT_NE(run_burl(scratch, "list parameters").out.find("atlas.size"), std::string::npos);
    EXPECT_EQ(run_burl(scratch, "list trees").exit_code, 1);
    EXPECT_EQ(run_burl(scratch, "").exit_code, 1);
}

TEST(Program, TellsWhatEveryPresetIs) {
    const Scratch scratch;
    const std::string table = run_burl(scratch, "list recipes").out;
    const auto json = nlohmann::json::parse(run_burl(scratch, "list recipes --json").out);
    EXPECT_GT(json.size(), 20u);
    for (const auto& entry : json) {
        const auto text = entry["text"].get<std::string>();
        EXPECT_GT(text.size(), 20u) << entry;
        EXPECT_NE(table.find(text), std::string::npos) << text;
    }
    EXPECT_NE(table.find("Rings of early and late wood"), std::string::npos);
}

TEST(Program, SaysWhatAMisspeltWordMayHaveMeant) {
    const Scratch scratch;
    const std::pair<const char*, const char*> cases[] = {
        {"bke m.obj -o a.glb", "no verb or option 'bke'; did you mean bake?"},
        {"mertics m.obj", "did you mean metrics?"},
        {"--versoin", "did you mean --version?"},
        {"bake m.obj -o a.glb --recpie wood", "no option --recpie; did you mean --recipe?"},
        {"bake m.obj --ouput=a.glb", "no option --ouput; did you mean --output?"},
        {"bake --version", "--version is asked of burl itself, without a verb"},
        {"manual man metrisc", "did you mean 'metrics'?"},
        {"render m.obj -o a.png --supersampel 3", "did you mean --supersample?"},
        {"bake sample:cube -o a.glb --recipe wod", "did you mean \"wood\"?"},
        {"bake sample:teapto -o a.glb", "did you mean \"sample:teapot\"?"},
        {"bake sample:cube -o a.glb --atlas qaud", "did you mean \"quad\"?"},
        {"bake sample:cube -o a.glb --synth hots", "did you mean host?"},
        {"bake sample:cube -o a.glb --set solid.scal=2", "did you mean \"solid.scale\"?"},
        {"render --direct --plane cluods:0,1,0,1 -o a.png", "did you mean \"clouds\"?"},
        {"list recpies", "did you mean recipes?"},
        {"bench synthsis", "did you mean synthesis?"},
        {"eval --noise perln --points p.csv", "did you mean perlin?"},
        {"figures -o f --only seascpae", "did you mean \"seascape\"?"}};
    for (const auto& [arguments, hint] : cases) {
        const Outcome outcome = run_burl(scratch, arguments);
        EXPECT_EQ(outcome.exit_code, 1) << arguments;
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find(hint), std::string::npos) << outcome.err;
    }
    // Nothing is near to this.
    for (const char* arguments : {"xyzzy", "bake m.obj -o a.glb --xyzzy"})
        EXPECT_EQ(run_burl(scratch, arguments).err.find("did you mean"), std::string::npos);
}

TEST(Program, NamesTheOptionWhoseValueIsWrong) {
    const Scratch scratch;
    const std::pair<const char*, const char*> cases[] = {
        {"--size abc", "burl: --size abc: atlas.size is \"abc\", must be"},
        {"--atlas cube", "burl: --atlas cube: "},
        {"--tries 9", "burl: --tries 9: "},
        {"--filter boxy", "burl: --filter boxy: "},
        {"--filter supersample:abc", "burl: --filter supersample:abc: "},
        {"--set solid.scale=abc", "burl: --set solid.scale=abc: "}};
    for (const auto& [option, begin] : cases) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake sample:cube -o a.png {}", option));
        EXPECT_EQ(outcome.exit_code, 1) << option;
        EXPECT_TRUE(outcome.err.starts_with(begin)) << outcome.err;
        expect_one_sentence(outcome.err);
    }
}

TEST(Program, TellsItsOpenGl) {
    const Scratch scratch;
    for (const char* platform : {"osmesa", "egl"}) {
        const Outcome outcome = run_burl(scratch, fmt::format("list gl --gl {}", platform));
        if (outcome.exit_code == 5) {  // not installed, which is one sentence
            expect_one_sentence(outcome.err);
            continue;
        }
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        for (const char* fact : {"renderer ", "version ", "largest texture ", "float64 "})
            EXPECT_NE(outcome.out.find(fact), std::string::npos) << outcome.out;
    }
    for (const char* wrong : {"list gl --gl metal", "list recipes --gl egl"}) {
        const Outcome outcome = run_burl(scratch, wrong);
        EXPECT_EQ(outcome.exit_code, 1);
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find("--gl"), std::string::npos);
    }
}

TEST(Program, DrawsTheSameThroughEveryPlatformOfSoftwareOpenGl) {
    const Scratch scratch;
    const std::string mesh = scratch.write("square.obj", program_square);
    const auto draw = [&](const char* platform) {
        return run_burl(scratch, fmt::format("render '{}' -o '{}.png' --size 64x48 --gl {}", mesh,
                                             scratch / platform, platform));
    };
    if (draw("osmesa").exit_code == 5) GTEST_SKIP() << "OSMesa is not installed";
    const Outcome egl = draw("egl");
    if (egl.exit_code == 5) GTEST_SKIP() << egl.err;
    ASSERT_EQ(egl.exit_code, 0) << egl.err;
    // Another graphics processor rounds otherwise, here and there by more than a code at outlines.
    const std::string renderer = run_burl(scratch, "list gl --gl egl").out;
    if (renderer.find("llvmpipe") == std::string::npos) GTEST_SKIP() << renderer;
    EXPECT_EQ(slurp(scratch / "egl.png"), slurp(scratch / "osmesa.png"));
    EXPECT_EQ(draw("metal").exit_code, 1);
}

}  // namespace
}  // namespace burl::test
