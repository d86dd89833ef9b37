// Outputs are made again exactly when something that decides them has changed.
#include "app/bake/up_to_date.h"

#include <chrono>

#include "app/bake/job.h"
#include "app/base/sha256.h"
#include "app/image/image_io.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/kept_samples.h"

namespace burl::test {
namespace {

const char* const up_to_date_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

// The examples of FIPS 180-4's companion (NIST, "SHA256.pdf") and of RFC 6234.
TEST(Sha256, HasThePublishedDigests) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnThePieces) {
    const std::string text(1000, 'x');
    for (const std::size_t piece : {1u, 55u, 56u, 63u, 64u, 65u, 999u}) {
        Sha256 hash;
        for (std::size_t at = 0; at < text.size(); at += piece)
            hash.add(std::string_view(text).substr(at, piece));
        EXPECT_EQ(hash.digest(), sha256(text)) << piece;
    }
}

TEST(Sha256, OfAFileIsOfItsContent) {
    const Scratch scratch;
    const std::string content(700000, 'y');
    EXPECT_EQ(sha256_of_file(scratch.write("a.bin", content)), sha256(content));
    EXPECT_THROW(sha256_of_file(scratch / "none"), Error);
}

TEST(FileDigests, StayThoseOfTheFirstContent) {
    const Scratch scratch;
    const std::string file = scratch.write("a.bin", "first"), link = scratch / "link.bin";
    fs::create_symlink(file, link);
    FileDigests digests;
    EXPECT_EQ(digests.of(file), sha256("first"));
    scratch.write("a.bin", "second");
    EXPECT_EQ(digests.of(link), sha256("first"));
    EXPECT_THROW(digests.of(scratch / "none"), Error);
}

TEST(FileDigests, ThatOfAnImageIsOfTheBytesThatWereDecoded) {
    const Scratch scratch;
    const std::string file = scratch / "a.png";
    write_png(file, Image<Rgb8>(4, 4));
    const std::string bytes = slurp(file);
    RecipeImages images;
    images.pyramid(file, ImageWrap::repeat);
    write_png(file, Image<Rgb8>(8, 8));
    EXPECT_EQ(images.digests().of(file), sha256(bytes));
}

TEST(UpToDate, ARecordThatIsDamagedIsNone) {
    const Scratch scratch;
    const std::string out = scratch.write("a.png", "picture");
    const Json made_from = {{"burl", "1"}}, report = {{"mesh", 7}};
    EXPECT_FALSE(report_if_up_to_date(out, made_from));
    write_record(out, made_from, std::vector{file_there(out).value()}, report);
    EXPECT_EQ(report_if_up_to_date(out, made_from), report);
    EXPECT_FALSE(report_if_up_to_date(out, {{"burl", "2"}}));
    std::string text = slurp(record_path(out));
    text[text.find("mesh")] = 'M';
    for (const std::string& content : {std::string(), text}) {
        scratch.write("a.png.burl.json", content);
        EXPECT_FALSE(report_if_up_to_date(out, made_from)) << content;
    }
}

TEST(UpToDate, ARecordIsOfTheFilesThatItsBakeCommitted) {
    const Scratch scratch;
    const std::string out = scratch / "a.png";
    const Json made_from = {{"burl", "1"}}, report = {{"mesh", 7}};
    AtomicFile ours(out), theirs(out);
    ours.write("ours");
    theirs.write("of the other bake");
    const std::vector committed{ours.commit()};
    theirs.commit();
    write_record(out, made_from, committed, report);
    EXPECT_FALSE(report_if_up_to_date(out, made_from));
}

class UpToDateBake : public testing::Test {
  protected:
    const Scratch scratch;
    std::string mesh = scratch.write("square.obj", up_to_date_square), out = scratch / "a.png";

    /// Whether the bake had anything to do; its outputs are there afterwards.
    bool bakes(const std::string& options = "") {
        const auto before = fs::exists(out) ? fs::last_write_time(out) : fs::file_time_type();
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 64 {}", mesh, out, options));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_TRUE(fs::exists(out));
        const bool said = outcome.out.find("up to date") != std::string::npos;
        const bool written = fs::last_write_time(out) != before;
        EXPECT_EQ(said, !written) << outcome.out;
        return written;
    }
};

TEST_F(UpToDateBake, ASecondOneDoesNothingUnlessForced) {
    EXPECT_TRUE(bakes());
    EXPECT_FALSE(bakes());
    EXPECT_FALSE(bakes("--threads 1"));
    EXPECT_FALSE(bakes("--no-skip zero-terms"));
    EXPECT_TRUE(bakes("--force"));
    EXPECT_FALSE(bakes());
    EXPECT_TRUE(bakes("--no-skip up-to-date"));
}

TEST_F(UpToDateBake, WhateverDecidesTheOutputBringsItBack) {
    EXPECT_TRUE(bakes());
    for (const char* options :
         {"--recipe wood", "--set texture.input.noise.0.amplitude=0.1", "--atlas quad",
          "--depth 16", "--filter none", "--weld 0.01", "--levels 2", "--precision float64"}) {
        EXPECT_TRUE(bakes(options)) << options;
        EXPECT_FALSE(bakes(options)) << options;
    }
    EXPECT_TRUE(bakes());
    scratch.write("square.obj", std::string(up_to_date_square) + "v 2 0 0\nf 2 5 3\n");
    EXPECT_TRUE(bakes());
    EXPECT_FALSE(bakes());
}

/// The output has the images of materials that are not baked, too.
TEST_F(UpToDateBake, AnImageThatADocumentKeepsBringsItBack) {
    const std::string gltf = scratch / "two.gltf";
    const std::string made = fmt::format("bake sample:cube --recipe oak --size 16 -o '{}'", gltf);
    ASSERT_EQ(run_burl(scratch, made).exit_code, 0);
    Json document = Json::parse(slurp(gltf));
    Json &materials = document["materials"], &meshes = document["meshes"];
    materials.push_back(materials[0]);
    materials[0]["name"] = "baked", materials[1]["name"] = "kept";
    meshes.push_back(meshes[0]);
    meshes[1]["primitives"][0]["material"] = 1;
    document["nodes"].push_back({{"mesh", 1}});
    document["scenes"][0]["nodes"].push_back(1);
    mesh = scratch.write("two.gltf", document.dump());
    out = scratch / "two.glb";
    EXPECT_TRUE(bakes("--material baked"));
    EXPECT_FALSE(bakes("--material baked"));
    write_png(scratch / "two.png", Image<Rgb8>(4, 4));
    EXPECT_TRUE(bakes("--material baked"));
    EXPECT_FALSE(bakes("--material baked"));
}

TEST_F(UpToDateBake, OutputsThatWereTouchedAreMadeAgain) {
    EXPECT_TRUE(bakes("--levels 1"));
    const Image<Rgb8> picture = read_png(out);
    scratch.write("a.png", "painted over");
    EXPECT_TRUE(bakes("--levels 1"));
    EXPECT_EQ(read_png(out), picture);
    fs::remove(scratch / "a.1.png");
    EXPECT_TRUE(bakes("--levels 1"));
    EXPECT_TRUE(fs::exists(scratch / "a.1.png"));
    fs::remove(record_path(out));
    EXPECT_TRUE(bakes("--levels 1"));
    EXPECT_FALSE(bakes("--levels 1"));
}

TEST_F(UpToDateBake, ADamagedRecordMeansThatItIsBaked) {
    EXPECT_TRUE(bakes("--levels 1"));
    std::string text = slurp(record_path(out));
    text[text.find("\"coverage\"") + 1] = 'C';
    scratch.write("a.png.burl.json", text);
    EXPECT_TRUE(bakes("--levels 1"));
    scratch.write("a.png.burl.json", std::string(1000000, '['));
    EXPECT_TRUE(bakes("--levels 1"));
}

// What reads the mesh later, or has read it for another bake of a batch, may see either file.
TEST_F(UpToDateBake, InputsAreThoseOfItsBeginning) {
    BakeCommand command;
    command.mesh = mesh, command.out = out;
    const BakeJob job(command, {});
    scratch.write("square.obj", std::string(up_to_date_square) + "v 2 0 0\nf 2 5 3\n");
    EXPECT_EQ(job.made_from()["inputs"][0]["sha256"], sha256(up_to_date_square));
}

// The first bake writes frames when the mesh changes that the second one takes from it.
TEST_F(UpToDateBake, ABatchBakesAgainWhatChangedMeanwhile) {
    const std::string manifest = scratch.write("batch.json", R"({"bakes": [
        {"mesh": "square.obj", "output": "f.png", "size": 512, "frames": 9,
         "animate": "texture.input.noise.0.phase.2=0:1"},
        {"mesh": "square.obj", "output": "a.png", "size": 64}]})");
    const std::string batch = fmt::format("'{}/bin/burl' batch '{}'", binary_folder(), manifest);
    const std::string edited = fmt::format(
        "{} -q & while [ ! -e '{}' ]; do kill -0 $! || exit 8; sleep 0.01; done; kill -STOP $!; "
        "printf 'v 2 0 0\\nf 2 5 3\\n' >> '{}'; kill -CONT $!; wait $!",
        batch, scratch / "f.0001.png", mesh);
    ASSERT_EQ(std::system(edited.c_str()), 0);
    EXPECT_TRUE(fs::exists(out));
    EXPECT_TRUE(bakes());
    EXPECT_FALSE(bakes());
}

TEST_F(UpToDateBake, TheFilesOfAnotherBakeAreNotItsOwn) {
    const Json made_from = {{"recipe", "marble"}}, report = {{"output", out}};
    const CommittedFile mine = write_file(out, "a picture");
    write_record(out, made_from, {&mine, 1}, report);
    EXPECT_EQ(report_if_up_to_date(out, made_from), report);
    write_file(out, "another");  // of a bake that ran meanwhile, before this one's record
    write_record(out, made_from, {&mine, 1}, report);
    EXPECT_EQ(report_if_up_to_date(out, made_from), std::nullopt);
}

TEST_F(UpToDateBake, NamesThatAreNotUtf8AreReplacedInJson) {
    const std::string odd = scratch.write("m\xff.obj", up_to_date_square),
                      picture = scratch / "p\xfe.png";
    const std::string command = fmt::format("bake '{}' -o '{}' --size 64 --json", odd, picture);
    const Outcome outcome = run_burl(scratch, command);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(picture));
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["input"], scratch / "m\xef\xbf\xbd.obj");
    EXPECT_EQ(run_burl(scratch, command + fmt::format(" --report '{}'", scratch / "r\xfd.json"))
                  .exit_code,
              0);
}

TEST_F(UpToDateBake, TheReportIsThatOfTheBake) {
    const std::string command = fmt::format("bake '{}' -o '{}' --size 64 --json", mesh, out);
    const auto first = nlohmann::json::parse(run_burl(scratch, command).out);
    auto second = nlohmann::json::parse(run_burl(scratch, command).out);
    EXPECT_FALSE(first.contains("up_to_date"));
    EXPECT_EQ(second["up_to_date"], true);
    second.erase("up_to_date");
    EXPECT_EQ(second, first);
}

TEST_F(UpToDateBake, AFolderMayBeMovedAsAWhole) {
    fs::create_directory(scratch / "x");
    fs::create_directory(scratch / "y");
    const auto bake_from = [&](const char* folder, const char* arguments) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake {} --size 64 --levels 1 --json", arguments),
                     fmt::format("cd '{}/{}';", scratch.path().string(), folder));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return nlohmann::json::parse(outcome.out);
    };
    EXPECT_FALSE(bake_from("y", "../square.obj -o ../x/p.png").contains("up_to_date"));
    fs::rename(scratch / "x", scratch / "z");
    const auto report = bake_from(".", "./square.obj -o z/p.png");
    EXPECT_TRUE(report.contains("up_to_date"));
    EXPECT_EQ(report["input"], "./square.obj");
    EXPECT_EQ(report["outputs"], nlohmann::json::array({"z/p.png", "z/p.1.png"}));
}

/// An OBJ that is carved in part names the libraries of its mesh, and a kept .gltf its images.
TEST_F(UpToDateBake, FilesThatAnOutputNamesAreWhereItsMeshIs) {
    const std::string obj =
        "mtllib l.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n";
    for (const char* folder : {"a", "b"}) {
        fs::create_directory(scratch / folder);
        scratch.write(fmt::format("{}/m.obj", folder), obj);
        scratch.write(fmt::format("{}/l.mtl", folder), "newmtl a\nnewmtl b\n");
    }
    const auto bakes_from = [&](const std::string& source, const std::string& output,
                                const char* options) {
        mesh = scratch / source, out = scratch / output;
        return bakes(options);
    };
    for (const char* output : {"all.obj", "a.png", "a.ply"}) {
        EXPECT_TRUE(bakes_from("a/m.obj", output, ""));
        EXPECT_FALSE(bakes_from("b/m.obj", output, "")) << output;
    }
    EXPECT_TRUE(bakes_from("a/m.obj", "part.obj", "--material a"));
    EXPECT_FALSE(bakes_from("a/m.obj", "part.obj", "--material a"));
    EXPECT_TRUE(bakes_from("b/m.obj", "part.obj", "--material a"));
    EXPECT_NE(slurp(out).find("mtllib b/l.mtl\n"), std::string::npos);

    scratch.write("a/s.gltf", kept_samples().at("neighbour"));
    scratch.write("b/s.gltf", kept_samples().at("neighbour"));
    EXPECT_TRUE(bakes_from("a/s.gltf", "s.glb", "--mesh bar"));
    EXPECT_FALSE(bakes_from("b/s.gltf", "s.glb", "--mesh bar"));
    EXPECT_TRUE(bakes_from("a/s.gltf", "a/t.gltf", "--mesh bar"));
    EXPECT_FALSE(bakes_from("a/s.gltf", "a/t.gltf", "--mesh bar"));
    EXPECT_TRUE(bakes_from("b/s.gltf", "a/t.gltf", "--mesh bar"));
}

TEST_F(UpToDateBake, WhatAnEarlierBakeLeftBesideIsNamed) {
    const auto told = [&](const std::string& options) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 8 {}", mesh, out, options));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.err;
    };
    const std::string left = "left of an earlier bake: ";
    EXPECT_EQ(told("--recipe marble --levels all").find(left), std::string::npos);
    EXPECT_EQ(told("--recipe wood --levels all").find(left), std::string::npos) << "the same files";
    EXPECT_NE(told("--recipe wood --levels 1").find(left + "a.2.png and a.3.png\n"),
              std::string::npos);
    EXPECT_TRUE(fs::exists(scratch / "a.2.png")) << "named, not deleted";
    scratch.write("a.1.png", "another's");
    EXPECT_EQ(told("--recipe wood").find(left), std::string::npos) << "it is somebody else's";
}

TEST_F(UpToDateBake, TheRecordSaysWhatWentIn) {
    EXPECT_TRUE(bakes("--recipe wood"));
    const auto record = nlohmann::json::parse(slurp(record_path(out)));
    EXPECT_EQ(record["made_from"]["inputs"][0]["file"], "square.obj");
    EXPECT_EQ(record["made_from"]["inputs"][0]["sha256"], sha256(up_to_date_square));
    EXPECT_EQ(record["made_from"]["recipe"]["name"], "wood");
    EXPECT_EQ(record["outputs"][0]["file"], "a.png");
    EXPECT_EQ(record["outputs"][0]["state"]["bytes"], fs::file_size(out));
}

}  // namespace
}  // namespace burl::test
