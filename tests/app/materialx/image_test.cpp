// Images of a document: where they lie, and which numbers their codes become.
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "app/image/image_io.h"
#include "app/image/picture_coding.h"
#include "app/measure/evaluate_points.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/read/read_mesh.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

/// A document whose base colour is the node `n`, a color3.
void write_document(const ScratchFolder& scratch, const std::string& nodes) {
    std::ofstream(scratch / "a.mtlx")
        << "<materialx version=\"1.38\" colorspace=\"lin_rec709\">" << nodes
        << "<standard_surface name=\"S\" type=\"surfaceshader\"><input name=\"base\" "
           "type=\"float\" value=\"1\"/><input name=\"base_color\" type=\"color3\" "
           "nodename=\"n\"/></standard_surface></materialx>";
}

std::string image_node(const std::string& type, const std::string& file,
                       const std::string& rest = "") {
    return "<image name=\"" + std::string(type == "color3" ? "n" : "i") + "\" type=\"" + type +
           "\"><input name=\"file\" type=\"filename\" value=\"" + file +
           "\" colorspace=\"srgb_texture\"/>" + rest + "</image>";
}

/// A square whose texture coordinates are its x and y, v upwards.
Mesh unit_square(const ScratchFolder& scratch) {
    std::ofstream(scratch / "square.obj")
        << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
           "f 1/1 2/2 3/3 4/4\n";
    return read_mesh(scratch / "square.obj");
}

/// The colour of the document at a point of the square.
Vec3d color_at(const ScratchFolder& scratch, double x, double y) {
    const Mesh mesh = unit_square(scratch);
    PointFile file;
    file.points.push_back({x, y, 0.0, 0.0});
    const auto results = evaluate_points(load_recipe(scratch / "a.mtlx"), file, &mesh);
    return results[0].float64.color.value();
}

void expect_color(const Vec3d& color, const Vec3d& expected) {
    for (const double away : {color.x - expected.x, color.y - expected.y, color.z - expected.z})
        EXPECT_NEAR(away, 0.0, 1e-3);
}

constexpr Rgb8 red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, white{255, 255, 255};

/// Red and green above blue and white.
Image<Rgb8> four_pixels() {
    Image<Rgb8> image(2, 2);
    image(0, 0) = red;
    image(1, 0) = green;
    image(0, 1) = blue;
    image(1, 1) = white;
    return image;
}

TEST(MaterialXImage, TheFirstRowIsOnTop) {
    const ScratchFolder scratch;
    write_png(scratch / "p.png", four_pixels());
    write_document(scratch, image_node("color3", "p.png"));
    expect_color(color_at(scratch, 0.25, 0.75), {1.0, 0.0, 0.0});
    expect_color(color_at(scratch, 0.75, 0.75), {0.0, 1.0, 0.0});
    expect_color(color_at(scratch, 0.25, 0.25), {0.0, 0.0, 1.0});
}

TEST(MaterialXImage, PlacementsMoveIt) {
    const ScratchFolder scratch;
    write_png(scratch / "p.png", four_pixels());
    // Scaled by 1/2 the image shows twice; moved by half of it red stands where green was.
    write_document(scratch,
                   "<texcoord name=\"t\" type=\"vector2\"/><place2d name=\"p\" type=\"vector2\">"
                   "<input name=\"texcoord\" type=\"vector2\" nodename=\"t\"/><input "
                   "name=\"scale\" type=\"vector2\" value=\"0.5, 1\"/><input name=\"offset\" "
                   "type=\"vector2\" value=\"0.5, 0\"/></place2d>" +
                       image_node("color3", "p.png",
                                  "<input name=\"texcoord\" type=\"vector2\" nodename=\"p\"/>"));
    expect_color(color_at(scratch, 0.125, 0.75), {0.0, 1.0, 0.0});
    expect_color(color_at(scratch, 0.375, 0.75), {1.0, 0.0, 0.0});
}

TEST(MaterialXImage, NumbersAreTheFilesCodes) {
    const ScratchFolder scratch;
    for (const int code : {3, 40, 128, 250}) {
        Image<Rgb8> image(2, 2);
        for (std::size_t k = 0; k < 4; ++k)
            image(k % 2, k / 2) = {std::uint8_t(code), std::uint8_t(code), std::uint8_t(code)};
        write_png(scratch / "p.png", image);
        write_document(scratch, image_node("float", "p.png") +
                                    "<convert name=\"n\" type=\"color3\"><input name=\"in\" "
                                    "type=\"float\" nodename=\"i\"/></convert>");
        EXPECT_NEAR(color_at(scratch, 0.3, 0.6).x, code / 255.0, 1e-6) << code;
    }
}

void write_jpeg(const std::string& path, const Image<Rgb8>& image) {
    std::ofstream file(path, std::ios::binary);
    encode_jpeg(
        codes_of(image),
        [&](std::span<const std::uint8_t> bytes) {
            file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        },
        95);
}

TEST(MaterialXImage, MayBeJpeg) {
    const ScratchFolder scratch;
    Image<Rgb8> image(16, 16);
    for (std::size_t y = 0; y < 16; ++y)
        for (std::size_t x = 0; x < 16; ++x) image(x, y) = y < 8 ? Rgb8{200, 100, 50} : white;
    write_jpeg(scratch / "p.jpg", image);
    write_document(scratch, image_node("color3", "p.jpg"));
    const Vec3d top = color_at(scratch, 0.5, 0.8);
    EXPECT_NEAR(top.x, 0.578, 0.01);  // 200 of 255 in sRGB
    EXPECT_NEAR(top.y, 0.127, 0.01);
    EXPECT_NEAR(top.z, 0.0319, 0.01);
}

}  // namespace
}  // namespace burl
