// No command writes over what it reads: every output of every verb against every input, by whatever
// name; and what is no file is not waited for.
#include "app/export/command_files.h"
#include "app/recipe/edit/recipe_json.h"

#include <map>

#include "app/image/image_io.h"
#include "app/recipe/edit/images.h"
#include "atlas/base/error.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

/// Shell text that bounds the address space, of which the address sanitizer reserves terabytes.
std::string memory_limit([[maybe_unused]] int kib) {
#if defined(__SANITIZE_ADDRESS__)
    return "";
#else
    return fmt::format("ulimit -v {};", kib);
#endif
}

const char* const plate = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
const char* const pictured = R"({"texture": {"node": "map_uv", "input":
    {"node": "image", "file": "dots.png"}}})";
/// A mesh, a recipe and its image, and a scene with its buffer and image.
class CommandFilesOf : public testing::Test {
  protected:
    const Scratch scratch;

    CommandFilesOf() {
        scratch.write("m.obj", plate);
        scratch.write("r.json", pictured);
        write_png(scratch / "dots.png", Image<Rgb8>(4, 4));
        EXPECT_EQ(burl("bake m.obj -o scene.gltf --size 16").exit_code, 0);
        fs::remove(scratch / "scene.gltf.burl.json");
        fs::rename(scratch / "scene.gltf", scratch / "s.gltf");
    }
    /// In the folder.
    Outcome burl(const std::string& arguments, const std::string& prefix = "") const {
        return run_burl(scratch, arguments,
                        fmt::format("cd '{}'; {}", scratch.path().string(), prefix));
    }
    std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(scratch.path()))
            if (entry.is_regular_file()) all[entry.path().string()] = slurp(entry.path());
        return all;
    }
    /// In one sentence, and nothing is written.
    void expect_refused(const std::string& arguments) const {
        const auto before = contents();
        const Outcome outcome = burl(arguments);
        EXPECT_EQ(outcome.exit_code, int(ExitCode::io)) << arguments;
        expect_one_sentence(outcome.err);
        EXPECT_EQ(contents(), before) << arguments << "\n" << outcome.err;
    }
};

TEST_F(CommandFilesOf, OutputsLeaveTheInputsAlone) {
    for (const char* arguments : {
             // The buffer and the image of the mesh, its pose, its materials.
             "bake s.gltf -o scene.gltf",
             "bake s.gltf -o a.png --report scene.bin",
             "bake s.gltf -o a.png --emit-glsl scene.bin",
             "bake s.gltf -o scene.png",
             "bake m.obj -o scene.gltf --pose s.gltf",
             "bake m.obj -o a.png --emit-glsl m.obj",
             // The recipe and its image.
             "bake m.obj -r r.json -o dots.png",
             "bake m.obj -r r.json -o dots.gltf",
             "bake m.obj -r r.json -o a.png --report r.json",
             "bake m.obj -r r.json -o a.png --report dots.png",
             "render --direct m.obj -r r.json -o dots.png --size 8x8",
             "render --direct --plane r.json:0,0,1,0 -o dots.png --size 8x8",
             "render --lazy m.obj -r r.json -o dots.png --size 8x8",
             "render --lazy m.obj -r r.json -o a.png --report dots.png --size 8x8",
             "render s.gltf -o scene.png --size 8x8",
             "diff dots.png scene.png -o ./dots.png",
             "bench synthesis m.obj -r r.json -o dots.png",
             // One output over another.
             "bake m.obj -o a.png --report a.png",
             "bake m.obj -o a.gltf --emit-glsl a.bin",
             "bake m.obj -o a.png --report a.png.burl.json",
         })
        expect_refused(arguments);
}

TEST_F(CommandFilesOf, SoDoNumberedOutputs) {
    fs::rename(scratch / "dots.png", scratch / "dots.1.png");
    scratch.write("r.json", std::string(pictured).replace(std::string(pictured).find("dots.png"), 8,
                                                          "dots.1.png"));
    expect_refused("bake m.obj -r r.json -o dots.png --size 16 --levels 2");
    fs::rename(scratch / "dots.1.png", scratch / "d-uv-scale.png");
    scratch.write("r.json", std::string(pictured).replace(std::string(pictured).find("dots.png"), 8,
                                                          "d-uv-scale.png"));
    expect_refused("metrics s.gltf --uv -r r.json --size 16 --image d");
    fs::rename(scratch / "d-uv-scale.png", scratch / "d.0002.png");
    scratch.write("r.json", std::string(pictured).replace(std::string(pictured).find("dots.png"), 8,
                                                          "d.0002.png"));
    expect_refused("bake m.obj -r r.json -o d.png --frames 2 --animate solid.scale=1:2 --size 16");
}

TEST_F(CommandFilesOf, SoDoNormalsAndMaterials) {
    fs::rename(scratch / "dots.png", scratch / "d_normal.png");
    scratch.write("r.json", R"({"texture": {"node": "image", "file": "d_normal.png"},
        "bump": {"input": {"node": "wrinkled"}}})");
    expect_refused("bake m.obj -r r.json -o d.png --size 16");
    scratch.write("m.obj", std::string("mtllib parts.mtl\r\n") + plate);
    scratch.write("parts.mtl", "newmtl gold\n");
    expect_refused("bake m.obj -o parts.obj --size 16");
}

/// Libraries as the reader finds them: behind other blanks, several on a line, and on joined lines.
TEST_F(CommandFilesOf, SoDoLibrariesHoweverTheyAreNamed) {
    const std::string faces = std::string(plate) + "usemtl A\nf 1 2 3\nusemtl B\nf 1 3 4\n";
    for (const char* lines :
         {"mtllib\tparts.mtl\n", " mtllib parts.mtl\n", "\xef\xbb\xbfmtllib parts.mtl\n",
          "mtllib other.mtl parts.mtl\n", "mtllib \\\nparts.mtl\n",
          "mtllib other.mtl \\\r\n parts.mtl", "mtllib other.mtl\nmtllib parts.mtl # ours\n"}) {
        scratch.write("m.obj", lines + ("\n" + faces));
        scratch.write("parts.mtl", "newmtl A\nnewmtl B\n");
        expect_refused("bake m.obj -o parts.obj --material A --size 16");
    }
}

/// Pictures of an OBJ's materials are read as those of a glTF are.
TEST_F(CommandFilesOf, SoDoPicturesOfLibraries) {
    fs::create_directory(scratch / "sub");
    scratch.write("b.json", R"({"bump": {"input": {"node": "wrinkled"}}})");
    scratch.write("m.obj", "mtllib sub/parts.mtl none.mtl\nusemtl A\n" + std::string(plate) +
                               "usemtl B\nf 1 2 3\n");
    const auto refused_beside = [&](const std::string& line, const std::string& picture,
                                    const std::string& bake) {
        SCOPED_TRACE(line);
        scratch.write("sub/parts.mtl", "newmtl B\n" + line + "\n");
        scratch.write(picture, "mine");
        expect_refused(fmt::format("bake m.obj --size 32 {}", bake));
        fs::remove(scratch / picture);
    };
    refused_beside("map_Kd wall.png", "sub/wall.png", "--material A -o sub/wall.obj");
    refused_beside("map_Kd wall.png", "wall.png", "-o wall.ply");
    refused_beside("  map_kd\t-s 2 2 2 -o 0.5 -clamp on my wall.png\r", "sub/my wall.png",
                   "-o 'sub/my wall.png'");
    refused_beside("bump -bm 0.5 tex.1.png", "sub/tex.1.png", "-o sub/tex.png --levels 1");
    refused_beside("norm n_normal.png", "sub/n_normal.png", "-r b.json -o sub/n.png");
    refused_beside("disp -mm 0 1 d.png", "sub/d.png", "-o sub/d.png");
    refused_beside("refl -type sphere r.png", "sub/r.png", "-o sub/r.png");
    refused_beside("decal c.png", "sub/c.png", "-o sub/c.png");
    refused_beside("map_Ke ..\\sub\\k.png", "sub/k.png", "-o sub/k.png");
    refused_beside("# roughness and metallic: a_orm.png", "sub/a_orm.png", "-o sub/a_orm.png");
}

TEST_F(CommandFilesOf, ByWhateverName) {
    fs::create_directory(scratch / "sub");
    fs::create_symlink("../dots.png", scratch / "sub/link.png");
    fs::create_directory_symlink(".", scratch / "here");
    fs::create_hard_link(scratch / "m.obj", scratch / "hard.json");
    for (const char* arguments :
         {"bake m.obj -r r.json -o sub/link.png", "bake m.obj -r r.json -o here/here/dots.png",
          "bake m.obj -r r.json -o sub/../dots.png", "bake m.obj -o a.png --report hard.json",
          "bake here/m.obj -o a.png --report m.obj"})
        expect_refused(arguments);
    // Two names of a file that is not there yet.
    fs::create_symlink("new.png", scratch / "report.json");
    expect_refused("bake m.obj -o new.png --report report.json");
}

TEST_F(CommandFilesOf, OtherNamesAreFree) {
    EXPECT_EQ(burl("bake s.gltf -r r.json -o other.gltf --size 16 --levels 1 --report r.txt "
                   "--emit-glsl s.frag --solid-map s.exr")
                  .exit_code,
              0);
    // Presets are no files.
    EXPECT_EQ(burl("bake m.obj -r wood -o a.png --size 16 --report wood").exit_code, 0);
    EXPECT_EQ(burl("bake m.obj -r r.json -o other.png --size 16 --force").exit_code, 0);
}

TEST_F(CommandFilesOf, ImagesThatAreNoFilesAreNotWaitedFor) {
    scratch.write("points.csv", "0.5,0.5,0\n");
    for (const char* make : {"mkfifo pipe.png", "ln -s /dev/zero pipe.png", "mkdir pipe.png",
                             "head -c 30 /dev/zero > pipe.png", "ln -s pipe.png pipe.png"}) {
        ASSERT_EQ(std::system(
                      fmt::format("cd '{}' && rm -rf pipe.png && {}", scratch.path().string(), make)
                          .c_str()),
                  0);
        scratch.write("r.json", R"({"texture": {"node": "image", "file": "pipe.png"}})");
        const Outcome outcome =
            burl("eval r.json --points points.csv", memory_limit(4000000) + " timeout -s KILL 20");
        EXPECT_TRUE(outcome.exit_code == int(ExitCode::io) ||
                    outcome.exit_code == int(ExitCode::invalid_file))
            << make << ": " << outcome.exit_code;
        expect_one_sentence(outcome.err);
        EXPECT_NE(outcome.err.find("pipe.png"), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(burl("eval /dev/zero --points points.csv", memory_limit(4000000)).exit_code,
              int(ExitCode::io));
    EXPECT_EQ(burl("eval marble --points pipe.csv", "mkfifo pipe.csv; cat points.csv >pipe.csv &")
                  .exit_code,
              0);
}

// Four and sixteen nodes of one image whose pyramid takes a gigabyte.
TEST_F(CommandFilesOf, NodesOfOneImageShareItsPyramid) {
    scratch.write("points.csv", "0.5,0.5,0\n");
    for (const char* recipe : {"r4.json", "d_imgs16.json"}) {
        const Outcome outcome = burl(
            fmt::format("eval '{}' --points points.csv", case_file(recipe)), memory_limit(2500000));
        EXPECT_EQ(outcome.exit_code, 0) << recipe << outcome.err;
        EXPECT_NE(outcome.out.find("0.5,0.5,0,"), std::string::npos) << outcome.out;
    }
}

TEST(RecipeImages, AreReadOnce) {
    const Scratch scratch;
    write_png(scratch / "a.png", Image<Rgb8>(4, 4));
    const char* const thrice = R"({"texture": {"node": "mix", "a": {"node": "image",
        "file": "a.png", "wrap": "black"}, "b": {"node": "mix", "a": {"node": "image",
        "file": "a.png"}, "b": {"node": "image", "file": "./a.png"}}}})";
    RecipeImages images;
    const Recipe recipe = parse_recipe(thrice, scratch / "r.json", {}, images);
    ASSERT_EQ(recipe.texture.images.size(), 3u);
    EXPECT_EQ(recipe.texture.images[2].pixels, recipe.texture.images[1].pixels);
    EXPECT_NE(recipe.texture.images[1].pixels, recipe.texture.images[0].pixels) << "another wrap";
    EXPECT_EQ(parse_recipe(thrice, scratch / "r.json"), recipe);
    const Recipe again = parse_recipe(thrice, scratch / "r.json", {"solid.scale=2"}, images);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(again.texture.images[i].pixels, recipe.texture.images[i].pixels);
}

/// The head of a PNG of that size, which has no pixels.
std::string png_head(std::uint32_t width, std::uint32_t height) {
    std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    for (const std::uint32_t side : {width, height})
        for (int shift = 24; shift >= 0; shift -= 8) head += char(side >> shift & 255u);
    return head;
}

TEST(RecipeImages, AreBoundedBeforeTheyAreDecoded) {
    const Scratch scratch;
    const auto problem = [&](const std::string& texture) -> std::string {
        try {
            parse_recipe("{\"texture\": " + texture + "}", scratch / "r.json");
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::invalid_file);
            return error.what();
        }
        return "accepted";
    };
    scratch.write("claims.png", png_head(0x7fffffff, 0x7fffffff));
    EXPECT_NE(problem(R"({"node": "image", "file": "claims.png"})").find("2147483647 x 2147483647"),
              std::string::npos);
    // Three pyramids of 8192 x 8192, the third by its wrap; none is decoded before all are counted.
    scratch.write("a.png", png_head(8192, 8192));
    scratch.write("b.png", png_head(4097, 5000));
    const auto mix = [](const char* wrap) {
        return fmt::format(R"({{"node": "mix", "a": {{"node": "mix",
            "a": {{"node": "image", "file": "a.png"}}, "b": {{"node": "image", "file": "b.png"}}}},
            "b": {{"node": "image", "file": "b.png", "wrap": "{}"}}}})",
                           wrap);
    };
    EXPECT_NE(problem(mix("black"))
                  .find("b.png: with this image the recipe's images have "
                        "201326592 pixels together"),
              std::string::npos);
    EXPECT_NE(problem(mix("repeat")).find("a.png: damaged PNG image"), std::string::npos);
}

TEST(FileNames, KnowsAFileByItsNamesAndItsInode) {
    const Scratch scratch;
    const std::string file = scratch.write("a.txt", "x");
    fs::create_hard_link(file, scratch / "b.txt");
    FileNames names;
    names.add(file, "first");
    names.add(scratch / "./a.txt", "second");
    names.add(scratch / "new.txt", "third");
    ASSERT_NE(names.find(scratch / "b.txt"), nullptr);
    EXPECT_EQ(names.find(scratch / "b.txt")->name, file);
    EXPECT_EQ(names.find(scratch / "b.txt")->note, "first");
    ASSERT_NE(names.find(scratch / "none/../new.txt"), nullptr);
    EXPECT_EQ(names.find_path(scratch / "b.txt"), nullptr);
    names.add(scratch / "b.txt", "fourth");
    ASSERT_NE(names.find_path(scratch / "b.txt"), nullptr);
    EXPECT_EQ(names.find_path(scratch / "b.txt")->note, "fourth");
    EXPECT_EQ(names.find(file)->note, "first");
    EXPECT_EQ(names.find(scratch / "c.txt"), nullptr);
}

TEST(FilesOfMesh, AreThoseThatAreReadAndThoseNamedBesides) {
    const Scratch scratch;
    const auto read = [](const std::string& path) { return files_of_mesh(path, MeshFiles::read); };
    EXPECT_TRUE(files_of_mesh("sample:teapot").empty());
    EXPECT_TRUE(files_of_mesh("").empty());
    const std::string gltf = scratch.write("a.gltf", R"({"images": [{"uri": "a.png"}],
        "buffers": [{"uri": "two%20words.bin"}, {"uri": "data:,x"}, {"uri": "../no.bin"}]})");
    std::vector<std::string> files{gltf, scratch / "two words.bin"};
    EXPECT_EQ(read(gltf), files);
    files.push_back(scratch / "a.png");
    EXPECT_EQ(files_of_mesh(gltf), files);
    const std::string obj = scratch.write("a.obj", "mtllib a.mtl\n");
    EXPECT_EQ(read(obj), std::vector{obj});
    EXPECT_EQ(files_of_mesh(obj), std::vector{obj}) << "its library is not there";
    const std::string library = scratch.write("a.mtl", "map_Kd a.png\nmap_Ke b.png\n");
    const std::string picture = scratch.write("b.png", "");
    EXPECT_EQ(files_of_mesh(obj), (std::vector{obj, library, picture}));
    const std::string damaged = scratch.write("b.gltf", "{");
    EXPECT_EQ(read(damaged), std::vector{damaged});
}

TEST(CommandFiles, RefusesInEitherOrder) {
    const Scratch scratch;
    const std::vector<std::string> input{scratch.write("a.png", "x")};
    CommandFiles files;
    files.write(scratch / "./a.png", ".png");
    EXPECT_THROW(files.read(input), Error);
    CommandFiles others;
    others.read(input);
    EXPECT_THROW(others.write(scratch / "./a.png", ".png"), Error);
    others.write(scratch / "b.png");
    EXPECT_THROW(others.write(scratch / "b.png"), Error);
    EXPECT_THROW(others.write(scratch / "c.jpg", ".png"), Error);
    EXPECT_THROW(others.write(scratch / "none/c.png"), Error);
}

}  // namespace
}  // namespace burl::test
