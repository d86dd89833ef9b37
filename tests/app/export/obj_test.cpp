// The OBJ's text parsed again, line by line, and compared with the mesh and atlas it came from.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/export/export.h"
#include "app/image/image_io.h"
#include "app/surface/normals.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

struct ObjText {
    std::vector<Vec3d> points, normals;
    std::vector<Vec2d> uvs;
    std::vector<std::array<std::array<std::size_t, 3>, 3>> faces;  // per corner v, vt, vn from 0
    std::vector<std::string> objects;
    std::string mtllib, usemtl;
};

ObjText parse(const std::string& path) {
    ObjText obj;
    std::ifstream file(path);
    EXPECT_TRUE(file.good());
    for (std::string line; std::getline(file, line);) {
        std::istringstream in(line);
        std::string key;
        in >> key;
        if (key == "v" || key == "vn") {
            Vec3d p;
            in >> p.x >> p.y >> p.z;
            (key == "v" ? obj.points : obj.normals).push_back(p);
        } else if (key == "vt") {
            Vec2d uv;
            in >> uv.x >> uv.y;
            obj.uvs.push_back(uv);
        } else if (key == "f") {
            obj.faces.emplace_back();
            for (auto& corner : obj.faces.back()) {
                char slash = 0;
                in >> corner[0] >> slash >> corner[1] >> slash >> corner[2];
                for (std::size_t& n : corner) --n;
            }
        } else if (key == "mtllib" || key == "usemtl" || key == "o") {
            std::string rest;
            std::getline(in >> std::ws, rest);
            if (key == "o") obj.objects.push_back(rest);
            if (key == "mtllib") obj.mtllib = rest;
            if (key == "usemtl") obj.usemtl = rest;
        }
        EXPECT_FALSE(in.fail()) << line;
    }
    return obj;
}

std::string export_obj_content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

TEST(ExportObj, EveryDigitAndEveryFaceIsKept) {
    const ScratchFolder folder;
    Mesh mesh = sphere_mesh(9, 14);
    for (Vec3d& p : mesh.positions) p = 1e6 * Vec3d(1, 2, 3) + p / 3.0;
    const Atlas atlas = pair_atlas(mesh, 100);
    export_scene(folder / "a.obj", mesh, atlas, sample_image(100), {});
    const ObjText obj = parse(folder / "a.obj");
    const auto normals = corner_normals(mesh, 40.0);
    EXPECT_EQ(obj.points, mesh.positions) << "the same doubles, in the same order";
    ASSERT_EQ(obj.faces.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < obj.faces.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [v, vt, vn] = obj.faces[t][k];
            EXPECT_EQ(v, mesh.triangles[t][k]);
            const Vec2d texel = atlas.corners[t][k];
            EXPECT_NEAR(obj.uvs.at(vt).x, texel.x / 100, 1e-15);
            EXPECT_NEAR(obj.uvs.at(vt).y, 1 - texel.y / 100, 1e-15) << "v upwards";
            EXPECT_EQ(Vec3f(obj.normals.at(vn)), normals[3 * t + k]);
        }
    }
}

TEST(ExportObj, MaterialNamesTheTexture) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    export_scene(folder / "my cube.obj", mesh, pair_atlas(mesh, 64), sample_image(64), {});
    EXPECT_EQ(folder.entries(), 3u);
    const ObjText obj = parse(folder / "my cube.obj");
    EXPECT_EQ(obj.mtllib, "my cube.mtl");
    const std::string mtl = export_obj_content(folder / "my cube.mtl");
    EXPECT_NE(mtl.find("newmtl " + obj.usemtl + "\n"), std::string::npos);
    EXPECT_NE(mtl.find("map_Kd my cube.png\n"), std::string::npos);
    EXPECT_EQ(read_png(folder / "my cube.png"), sample_image(64));
}

/// MTL has no cutoff, so that alpha of a mask must be there or not; what blends keeps it.
TEST(ExportObj, AlphaOfAMaskIsThereOrNot) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    Image<Rgba8> image(64, 64);
    for (std::size_t y = 0; y < 64; ++y)
        for (std::size_t x = 0; x < 64; ++x) image(x, y) = {200, 100, 50, std::uint8_t(4 * x)};
    ExportOptions options;
    options.material.alpha_cutoff = 0.5;
    for (const AlphaMode mode : {AlphaMode::blend, AlphaMode::mask}) {
        options.material.alpha = mode;
        export_scene(folder / "a.obj", mesh, pair_atlas(mesh, 64), image, options);
        EXPECT_NE(export_obj_content(folder / "a.mtl").find("map_d -imfchan m a.png\n"),
                  std::string::npos);
        const auto read = decode_png_with_alpha(read_png_bytes(folder / "a.png"), "a.png");
        const auto& seen = std::get<Image<Rgba8>>(read);
        for (std::size_t x = 0; x < 64; ++x)
            EXPECT_EQ(seen(x, 9).a, mode == AlphaMode::blend ? 4 * x : x >= 32 ? 255u : 0u) << x;
    }
}

TEST(ExportObj, MaterialIsCalledAfterMeshAndRecipeInOneWord) {
    const ScratchFolder folder;
    Mesh mesh = cube_mesh();
    mesh.name = "my #2\tcube";
    ExportOptions options;
    options.recipe_name = "sea ice";
    export_scene(folder / "a.obj", mesh, pair_atlas(mesh, 64), sample_image(64), options);
    EXPECT_EQ(parse(folder / "a.obj").usemtl, "my__2_cube_sea_ice");
    EXPECT_TRUE(export_obj_content(folder / "a.mtl").starts_with("newmtl my__2_cube_sea_ice\n"));
}

TEST(ExportObj, NamesDoNotJoinLines) {
    const ScratchFolder folder;
    Mesh mesh = cube_mesh();
    mesh.name = mesh.parts[0].name = "a\\";
    ExportOptions options;
    options.recipe_name = "b\\";
    export_scene(folder / "a.obj", mesh, pair_atlas(mesh, 64), sample_image(64), options);
    const ObjText obj = parse(folder / "a.obj");
    EXPECT_EQ(obj.objects, std::vector<std::string>{"a_"});
    EXPECT_EQ(obj.usemtl, "a\\_b_");
    EXPECT_EQ(obj.faces.size(), 12u);
}

TEST(ExportObj, SharedCornersShareLines) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    export_scene(folder / "a.obj", mesh, pair_atlas(mesh, 64), sample_image(64), {});
    const ObjText obj = parse(folder / "a.obj");
    EXPECT_EQ(obj.points.size(), 8u);
    EXPECT_EQ(obj.uvs.size(), 24u);
    EXPECT_EQ(obj.normals.size(), 6u);
}

TEST(ExportObj, FurtherPlacementsFollowAsCopies) {
    const ScratchFolder folder;
    Mesh mesh = cube_mesh(Vec3d(2, 0, 0));
    const Mat4d mirrored = placement(30, Vec3d(1, 1, -2), {1, 2, 3});
    mesh.parts = {{"leg\nv 0 0 0", 0, 4, {Mat4d(1.0), mirrored}}, {"top", 4, 8, {Mat4d(1.0)}}};
    export_scene(folder / "a.obj", mesh, pair_atlas(mesh, 64), sample_image(64), {});
    const ObjText obj = parse(folder / "a.obj");
    EXPECT_EQ(obj.objects, (std::vector<std::string>{"leg_v 0 0 0", "top", "leg_v 0 0 0 2"}));
    ASSERT_EQ(obj.faces.size(), 12u + 4u);
    for (std::size_t t = 0; t < 4; ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& original = obj.faces[t][k];
            const auto& copy = obj.faces[12 + t][(3 - k) % 3];  // turned over by the mirror
            const Vec3d expected(mirrored * Vec4d(obj.points.at(original[0]), 1));
            EXPECT_LT(glm::distance(obj.points.at(copy[0]), expected), 1e-12);
            EXPECT_EQ(original[1], copy[1]) << "the same texels";
        }
        const auto& f = obj.faces[12 + t];
        const Vec3d flat =
            glm::normalize(glm::cross(obj.points.at(f[1][0]) - obj.points.at(f[0][0]),
                                      obj.points.at(f[2][0]) - obj.points.at(f[0][0])));
        EXPECT_GT(glm::dot(flat, obj.normals.at(f[0][2])), 0.999);
    }
}

}  // namespace
}  // namespace burl
