// Damaged files of every format: cut off after every byte, and with random bytes changed. Reading
// must return or throw Error; anything else (a crash, another exception, a sanitizer report) fails.
#include <random>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/readers.h"
#include "tests/atlas/support/gltf_files.h"

namespace burl {
namespace {

using test::bytes_of;
using test::GltfFile;

struct Sample {
    std::string name;
    std::string content;
};

std::string binary_ply(bool big) {
    std::string body = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                       "_endian 1.0\nelement vertex 4\nproperty float x\nproperty double y\n"
                       "property float z\nproperty uchar red\nproperty uchar green\n"
                       "property uchar blue\nelement face 2\n"
                       "property list uchar int vertex_indices\nelement tristrips 1\n"
                       "property list int int vertex_indices\nend_header\n";
    for (int i = 0; i < 4; ++i)
        body += bytes_of(float(i % 2), big) + bytes_of(double(i / 2), big) + bytes_of(0.5f, big) +
                "abc";
    for (const auto& face : std::vector<std::vector<int>>{{0, 1, 2}, {0, 1, 3, 2}}) {
        body += bytes_of(static_cast<std::uint8_t>(face.size()));
        for (const int index : face) body += bytes_of(index, big);
    }
    body += bytes_of(5, big);
    for (const int index : {0, 1, -1, 2, 3}) body += bytes_of(index, big);
    return body;
}

GltfFile small_gltf() {
    GltfFile file;
    const int points = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int normals = file.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
    const int which = file.view(GltfFile::packed<std::uint8_t>({2}));
    const int value = file.view(GltfFile::packed<float>({0, 2, 0}));
    file.root["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", which}, {"componentType", 5121}}},
        {"values", {{"bufferView", value}}}};
    file.mesh({{"attributes", {{"POSITION", points}, {"NORMAL", normals}}},
               {"indices", file.shorts({0, 1, 2})}});
    file.node({{"mesh", 0}, {"rotation", {0, 0, 0, 1}}});
    file.node({{"children", {0}}, {"scale", {1, 2, 3}}});
    file.root["images"] = {{{"bufferView", which}, {"mimeType", "image/png"}}};
    file.root["scenes"] = {{{"nodes", {1}}}};
    return file;
}

std::vector<Sample> samples() {
    std::string stl(80, 's');
    stl += bytes_of(2u) + std::string(100, '\x3f');
    return {
        {"a.obj",
         "v 0 0 0\nv 1 0 0 0.5 0.5 1\nv 1 1 0\nv 0 1 0\nvt 0 1\nvn 0 0 1\n"
         "f 1/1/1 2//1 3 \\\n 4\nf -1 -2 -3\nl 1 2\n"},
        {"a.off",
         "COFF # c\n4 2 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n1 1 0 0 1 0 1\n0 1 0 0 0 1 1\n"
         "4 0 1 2 3\n3 0 2 1 255 0 0\n"},
        {"ascii.ply",
         "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
         "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 2 1\n"},
        {"little.ply", binary_ply(false)},
        {"big.ply", binary_ply(true)},
        {"ascii.stl",
         "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
         "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n"},
        {"binary.stl", stl},
        {"a.gltf", small_gltf().gltf()},
        {"a.glb", small_gltf().glb()},
    };
}

/// True when the file was read, false when it was refused; anything else escapes.
bool survives(const std::string& name, const std::string& content) {
    try {
        const Mesh mesh = build_mesh(parse_mesh(buffer_from(content, name)), name);
        EXPECT_FALSE(mesh.triangles.empty());
        for (const Triangle& t : mesh.triangles)
            for (const std::uint32_t point : t) EXPECT_LT(point, mesh.positions.size());
        EXPECT_EQ(build_connectivity(mesh).neighbours.size(), mesh.triangles.size());
        return true;
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()), "");
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        return false;
    }
}

TEST(HostileMesh, TheSamplesAreSound) {
    for (const Sample& sample : samples())
        EXPECT_TRUE(survives(sample.name, sample.content)) << sample.name;
}

TEST(HostileMesh, CutOffAfterEveryByte) {
    for (const Sample& sample : samples())
        for (std::size_t size = 0; size < sample.content.size(); ++size)
            survives(sample.name, sample.content.substr(0, size));
}

TEST(HostileMesh, RandomBytesChanged) {
    std::mt19937 random(20250101);
    const auto pick = [&](std::size_t n) { return random() % n; };
    for (const Sample& sample : samples())
        for (int round = 0; round < 3000; ++round) {
            std::string content = sample.content;
            for (std::size_t change = 1 + pick(4); change > 0; --change) {
                const std::size_t at = pick(content.size());
                if (pick(3) == 0)
                    content[at] = static_cast<char>(pick(256));
                else if (pick(2) == 0)
                    content[at] = "0123456789-.e# \n\\/"[pick(18)];
                else if (pick(2) == 0)
                    content.erase(at, 1 + pick(8));
                else
                    content.insert(at, content.substr(pick(content.size()), 1 + pick(8)));
                if (content.empty()) content.push_back('x');
            }
            survives(sample.name, content);
        }
}

}  // namespace
}  // namespace burl
