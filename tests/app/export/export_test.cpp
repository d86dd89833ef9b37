// The door itself: which file name means what, what is refused before the work, and that a failed
// export leaves nothing.
#include "app/export/export.h"

#include <csignal>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "app/export/command_files.h"
#include "app/image/image_io.h"
#include "atlas/base/error.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

template <class Action>
std::pair<ExitCode, std::string> failure(Action action) {
    try {
        action();
    } catch (const Error& e) {
        return {e.code(), e.what()};
    }
    return {ExitCode::ok, ""};
}

TEST(Export, UnknownExtensionsAreAUsageErrorThatListsTheKnown) {
    const ScratchFolder folder;
    for (const std::string name : {"a.xyz", "a", "glb", "a.glb.bak"}) {
        const auto [code, message] = failure([&] { output_paths(folder / name); });
        EXPECT_EQ(code, ExitCode::usage) << name;
        for (const char* known :
             {".glb", ".gltf", ".obj", ".mtlx", ".png", ".jpg", ".webp", ".ktx2", ".exr"}) {
            EXPECT_NE(message.find(known), std::string::npos) << message;
        }
    }
    EXPECT_EQ(failure([&] { output_paths(folder / ""); }).first, ExitCode::io);
    EXPECT_EQ(failure([&] { output_paths(""); }).first, ExitCode::usage);
    for (const char* name : {"a.glb", "a.GLB", "b.Gltf", "c.obj", "d.png", "e.exr", "f.jpg",
                             "f.JPEG", "g.webp", "h.ktx2"}) {
        EXPECT_NO_THROW(output_paths(folder / name)) << name;
    }
}

TEST(Export, BadPlacesAreFoundBeforeTheWork) {
    const ScratchFolder folder;
    std::ofstream(folder / "file") << "x";
    std::filesystem::create_directory(folder / "folder.glb");
    std::filesystem::create_directory(folder / "a.png");
    for (const char* name : {"missing/a.glb", "file/a.glb", "folder.glb", "a.obj", "a.gltf"}) {
        const auto [code, message] = failure([&] {
            CommandFiles files;
            for (const std::string& path : output_paths(folder / name)) files.write(path);
        });
        EXPECT_EQ(code, ExitCode::io) << name;
        EXPECT_NE(message.find(folder.path()), std::string::npos) << message;
    }
}

TEST(Export, NamesItsFilesAndItsImage) {
    EXPECT_EQ(output_paths("x/a.obj"), (std::vector<std::string>{"x/a.obj", "x/a.mtl", "x/a.png"}));
    EXPECT_EQ(
        output_paths("a.mtlx", 1, true),
        (std::vector<std::string>{"a.mtlx", "a.obj", "a.mtl", "a.png", "a.1.png", "a_normal.png"}));
    EXPECT_EQ(output_paths("a.b.gltf"),
              (std::vector<std::string>{"a.b.gltf", "a.b.bin", "a.b.png"}));
    EXPECT_EQ(output_paths("a.glb"), (std::vector<std::string>{"a.glb"}));
    EXPECT_EQ(output_paths("a.jpeg", 1, true, {"orm"}, true),
              (std::vector<std::string>{"a.jpeg", "a.1.jpg", "a_normal.jpg", "a_normal.1.jpg",
                                        "a_orm.jpg", "a_orm.1.jpg"}));
    EXPECT_EQ(output_paths("a.ktx2", 5, true, {"orm"}),
              (std::vector<std::string>{"a.ktx2", "a_normal.ktx2", "a_orm.ktx2"}));
    EXPECT_EQ(output_paths("a.gltf", 1, false, {}, false, TextureFormat::webp),
              (std::vector<std::string>{"a.gltf", "a.bin", "a.webp", "a.1.webp"}));
    EXPECT_EQ(wanted_kind("a.exr", 8), ImageKind::rgb_float);
    EXPECT_EQ(wanted_kind("a.png", 16), ImageKind::rgb16);
    EXPECT_EQ(wanted_kind("a.glb", 8), ImageKind::rgb8);
}

TEST(Export, PicturesHoldImagesOfEitherDepth) {
    const ScratchFolder folder;
    const Mesh mesh = cube_mesh();
    const Atlas atlas = pair_atlas(mesh, 16);
    const Image<Rgb8> image8 = sample_image(16);
    Image<Rgb16> image16(16, 16);
    for (std::size_t y = 0; y < 16; ++y) {
        for (std::size_t x = 0; x < 16; ++x) {
            const Rgb8 p = image8(x, y);
            image16(x, y) = {std::uint16_t(p.r * 257), std::uint16_t(p.g * 257),
                             std::uint16_t(p.b * 257)};
        }
    }
    for (const BakedImage& image : {BakedImage(image8), BakedImage(image16)}) {
        export_scene(folder / "a.png", mesh, atlas, image, {});
        EXPECT_EQ(read_png(folder / "a.png"), image8) << image.index();
    }
}

TEST(Export, PicturesAreCodedAsAskedOrAsTheOutputIsCalled) {
    EXPECT_EQ(coding_asked("", "a.glb").format, TextureFormat::png);
    EXPECT_EQ(coding_asked("", "a.JPG").format, TextureFormat::jpeg);
    EXPECT_EQ(coding_asked("webp:80", "a.obj").quality, 80);
    EXPECT_EQ(coding_asked("jpeg:80", "a.jpeg").quality, 80);
    EXPECT_EQ(coding_asked("ktx2", "a.obj").format, TextureFormat::ktx2);
    for (const auto& [text, path, why] : {std::array{"webp", "a.jpg", "extension"},
                                          {"png", "a.ktx2", "extension"},
                                          {"ktx2", "a.glb", "Basis"},
                                          {"ktx2:3", "a.gltf", "Basis"},
                                          {"tiff", "a.glb", "must be"}}) {
        const auto [code, message] = failure([&] { coding_asked(text, path); });
        EXPECT_EQ(code, ExitCode::usage) << text;
        EXPECT_NE(message.find(why), std::string::npos) << message;
    }
}

TEST(Export, AFullDiskLeavesNothing) {
    const ScratchFolder folder;
    const Mesh mesh = sphere_mesh(30, 40);
    const Atlas atlas = pair_atlas(mesh, 64);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    for (const char* name :
         {"a.glb", "a.gltf", "a.obj", "a.png", "a.exr", "a.jpg", "a.webp", "a.ktx2"}) {
        const rlimit limit{40, before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const BakedImage image = wanted_kind(name, 8) == ImageKind::rgb_float
                                     ? BakedImage(Image<RgbF>(64, 64))
                                     : sample_image(64);
        ExportOptions options;
        options.coding = coding_asked("", name);
        const auto [code, message] =
            failure([&] { export_scene(folder / name, mesh, atlas, image, options); });
        ::setrlimit(RLIMIT_FSIZE, &before);
        EXPECT_EQ(code, ExitCode::io) << name;
        EXPECT_NE(message.find("File too large"), std::string::npos) << message;
        EXPECT_EQ(folder.entries(), 0u) << name;
    }
    std::signal(SIGXFSZ, old_handler);
}

}  // namespace
}  // namespace burl
