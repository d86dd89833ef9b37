// The library's files: what they do not hold is told, and nothing that was read is replaced.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "burl/bake.h"
#include "tests/library/library_folder.h"

namespace {

/// The lines that the program says on stderr, without the output's name.
std::vector<std::string> said_by_burl(const std::string& words, const fs::path& where) {
    const std::string command =
        std::string(BURL_PROGRAM) + " " + words + " 2>" + (where / "said").string() + " >/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream file(where / "said");
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
        if (const auto colon = line.find(": "); line.find(" triangles, ") == std::string::npos)
            lines.push_back(line.substr(colon + 2));
    return lines;
}

TEST(LibraryFiles, TellsWhatTheFormatDoesNotHold) {
    const fs::path in = folder();
    const std::string source = (in / "source.glb").string();
    run_burl("bake sample:cube -r oak --size 64 -o " + source);
    burl::BakeOptions options;
    options.size = 64;
    const burl::Mesh mesh = burl::Mesh::read(source);
    const auto gold = burl::Recipe::load("gold"), marble = burl::Recipe::load("marble");
    const burl::Baked baked = burl::bake(mesh, gold, options);
    options.packing = "separate";
    const burl::Baked apart = burl::bake(mesh, gold, options);
    options.packing = "gltf";
    for (const std::string name : {"a.obj", "a.ply", "a.stl", "a.png"}) {
        const std::string out = (in / name).string();
        const std::string words =
            "bake " + source + (name == "a.stl" ? " -o " : " -r gold --size 64 -o ") + out;
        const std::vector<std::string> said = said_by_burl(words, in);
        EXPECT_EQ(burl::write(name == "a.stl" ? baked : apart, out), said) << name;
        EXPECT_EQ(said.size(), name == "a.ply" ? 3u : 1u) << name;
    }
    // The library makes a scene of its own where the program keeps the document.
    const std::vector<std::string> lost = burl::write(baked, (in / "a.glb").string());
    ASSERT_EQ(lost.size(), 1u);
    EXPECT_EQ(lost[0].find("not kept: 1 materials"), 0u) << lost[0];
    // A mesh of arrays has no document, and marble on a sample loses nothing.
    const burl::Baked plain = burl::bake(burl::Mesh(tetrahedron, faces), marble, options);
    EXPECT_EQ(burl::write(plain, (in / "b.glb").string()), std::vector<std::string>());
    options.depth = 16;
    const burl::Baked deep = burl::bake(burl::Mesh::read("sample:cube"), marble, options);
    EXPECT_EQ(burl::write(deep, (in / "c.glb").string()).size(), 1u);
    EXPECT_EQ(burl::write(deep, (in / "c.obj").string()), std::vector<std::string>());
}

TEST(LibraryFiles, ReplacesNothingThatItRead) {
    const fs::path in = folder();
    run_burl("bake sample:cube -r marble --size 64 -o " + (in / "a.obj").string());
    std::ofstream(in / "r.burl.json")
        << R"({"texture": {"node": "image", "file": "p.png"}, "atlas": {"size": 64}})";
    fs::copy(in / "a.png", in / "p.png");
    fs::create_symlink("a.obj", in / "link.obj");
    const burl::Baked baked = burl::bake(burl::Mesh::read((in / "a.obj").string()),
                                         burl::Recipe::load((in / "r.burl.json").string()));
    for (const char* name : {"a.obj", "a.png", "a.gltf", "p.png", "link.obj"}) {
        std::vector<std::string> before, after;
        const auto look = [&](std::vector<std::string>& files) {
            for (const auto& entry : fs::directory_iterator(in))
                files.push_back(entry.path().string() + bytes_of(entry.path()));
        };
        look(before);
        const auto [kind, sentence] = error_of([&] { burl::write(baked, (in / name).string()); });
        look(after);
        EXPECT_EQ(kind, burl::ErrorKind::io) << name;
        EXPECT_NE(sentence.find("was read from that file"), std::string::npos) << sentence;
        EXPECT_EQ(before, after) << name;
    }
    EXPECT_EQ(burl::write(baked, (in / "b.obj").string()).size(), 1u);  // texture coordinates
}

}  // namespace
