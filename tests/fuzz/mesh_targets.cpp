// Readers of meshes as text and as binary files, and the scene that is drawn of an OBJ.
#include <cmath>

#include "app/scene/scene.h"
#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/obj_source.h"
#include "atlas/read/readers.h"
#include "tests/fuzz/sound_mesh.h"
#include "tests/fuzz/target.h"
#include "tests/paths.h"

namespace burl::fuzz {
namespace {

void read_as(const std::string& bytes, const char* name) {
    for (const double weld : {0.0, 0.01}) {
        const ReadOptions options{.weld = weld};
        check_mesh(build_mesh(parse_mesh(buffer_from(bytes, name), options), name, options));
    }
}

void read_obj(const std::string& bytes) {
    read_as(bytes, "a.obj");
    const ObjSource source = read_obj_source(buffer_from(bytes, "a.obj"));
    const Mesh mesh = build_mesh(parse_obj(buffer_from(bytes, "a.obj")), "a.obj");
    require(points_of_corners(source, mesh).size() == source.faces.corners.size(),
            "every corner of an OBJ has a point of the mesh, or none");
    require(faces_of_materials(source, {"*"}).size() == source.faces.face_count(),
            "every face of an OBJ is chosen or not");
}

void read_off(const std::string& bytes) {
    read_as(bytes, "a.off");
}

void read_ply(const std::string& bytes) {
    read_as(bytes, "a.ply");
}

void read_stl(const std::string& bytes) {
    read_as(bytes, "a.stl");
}

/// Puts a small picture beside the scratch files as a.png.
void place_picture() {
    const FileBuffer file = read_file(test::source_folder() + "/tests/fuzz/corpus/png/rgb.png");
    static const std::string placed = scratch_file("a.png", std::string(file.text()));
}

/// An OBJ and, after a line "----", its material library a.mtl, which may name a picture a.png.
void read_obj_scene(const std::string& bytes) {
    constexpr std::string_view between = "\n----\n";
    const std::size_t end = bytes.find(between);
    if (end == std::string::npos) return;
    place_picture();
    scratch_file("a.mtl", bytes.substr(end + between.size()));
    load_scene(scratch_file("a.obj", bytes.substr(0, end)));
}

const std::vector<std::string_view> numbers{"0",
                                            "-0",
                                            "1",
                                            "-1",
                                            "1e308",
                                            "1e-320",
                                            "0x10",
                                            "nan",
                                            "inf",
                                            "1e999",
                                            "65536",
                                            "255",
                                            "0.3333",
                                            "2147483648",
                                            "-2147483649",
                                            "4294967295",
                                            "18446744073709551616"};

std::vector<std::string_view> with_numbers(std::vector<std::string_view> words) {
    words.insert(words.end(), numbers.begin(), numbers.end());
    return words;
}

}  // namespace

std::vector<Target> mesh_targets() {
    return {
        {"obj",
         read_obj,
         Form::text,
         {"assets/meshes/nasty", "tests/cases/metis.obj"},
         with_numbers({"v ",       "vt ",   "vn ",     "f ",      "fo ",   "l ",  "p ",    "g ",
                       "o ",       "s off", "usemtl ", "mtllib ", "\\\n",  "#",   "1/1/1", "1//1",
                       "-1/-1/-1", "vp ",   "curv ",   "end",     "bevel", "lod", "\r\n"})},
        {"off",
         read_off,
         Form::text,
         {},
         with_numbers({"OFF", "COFF", "NOFF", "STOFF", "4OFF", "nOFF", "BINARY", "#"})},
        {"ply",
         read_ply,
         Form::text,
         {},
         with_numbers({"ply",
                       "format ascii 1.0\n",
                       "format binary_little_endian 1.0\n",
                       "format binary_big_endian 1.0\n",
                       "comment ",
                       "obj_info ",
                       "element ",
                       "vertex ",
                       "face ",
                       "tristrips ",
                       "property ",
                       "list ",
                       "char",
                       "uchar",
                       "short",
                       "ushort",
                       "int",
                       "uint",
                       "float",
                       "double",
                       "int8",
                       "uint8",
                       "float64",
                       "vertex_indices",
                       "vertex_index",
                       "x",
                       "nx",
                       "red",
                       "alpha",
                       "s",
                       "texture_u",
                       "end_header\n"})},
        {"stl",
         read_stl,
         Form::text,
         {},
         with_numbers({"solid ", "facet normal ", "outer loop\n", "vertex ", "endloop\n",
                       "endfacet\n", "endsolid"})},
        {"obj-scene",
         read_obj_scene,
         Form::text,
         {},
         with_numbers({"newmtl ", "usemtl ", "mtllib a.mtl\n", "map_Kd a.png", "map_d ", "map_Pr ",
                       "norm ", "Kd ", "Ke ", "Ns ", "Pr ", "Pm ", "Ni ", "d ",
                       "# roughness and metallic: a.png", "-bm 1 ", "-o 0 0 0 ", "illum 2"})}};
}

}  // namespace burl::fuzz
