// Wavefront OBJ output. Text holds every digit, so positions are the input's doubles in its own
// coordinates, rather than centred floats. It is built in one buffer per kind of line and written
// in large pieces. A MaterialX document is written beside an OBJ.

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "app/base/unique_rows.h"
#include "app/export/formats.h"
#include "app/export/obj_text.h"
#include "app/export/placed_triangles.h"
#include "app/image/image_io.h"
#include "app/materialx/write/surface.h"
#include "app/surface/node_transform.h"
#include "procedural/color/srgb.h"

namespace burl {
namespace {

std::string file_name(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

/// The indices of a part's face lines per corner, from 1, before a copy's offsets.
struct FaceNumbers {
    std::vector<std::size_t> point, uv, normal;
};

FaceNumbers face_numbers(const Mesh& mesh, const Part& part, const CornerLines& lines) {
    FaceNumbers out;
    for (std::size_t i = 0; i < 3 * std::size_t(part.triangle_count); ++i) {
        const std::size_t c = 3 * std::size_t(part.first_triangle) + i;
        out.point.push_back(1 + std::size_t(mesh.triangles[c / 3][c % 3]));
        out.uv.push_back(lines.uv[c]);
        out.normal.push_back(lines.normal[c]);
    }
    return out;
}

/// Renumbers to 1, 2, ... by first use; returns the old numbers in the new order.
std::vector<std::size_t> compact(std::vector<std::size_t>& numbers) {
    UniqueRows<1> rows(numbers.size() / 3);
    for (std::size_t& n : numbers) n = 1 + std::size_t(rows.insert({std::uint32_t(n)}));
    std::vector<std::size_t> old;
    for (const auto& row : rows.rows()) old.push_back(row[0]);
    return old;
}

struct Offsets {
    std::size_t point = 0, normal = 0;
};

void print_faces(ObjText& text, const FaceNumbers& numbers, const Offsets& offsets,
                 bool turn_over) {
    for (std::size_t first = 0; first < numbers.point.size(); first += 3) {
        text.push_back('f');
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t c = first + (turn_over ? (3 - k) % 3 : k);
            print_corner(text, numbers.point[c] + offsets.point, numbers.uv[c],
                         numbers.normal[c] + offsets.normal);
        }
        text.push_back('\n');
    }
}

/// Prints all placements of a part but the first, with points and normals of their own and shared
/// vt lines.
void print_copies(ObjText& text, const Mesh& mesh, const Part& part, const CornerLines& lines,
                  std::span<const Vec4f> colors, Offsets& offsets) {
    FaceNumbers numbers = face_numbers(mesh, part, lines);
    const std::vector<std::size_t> points = compact(numbers.point);
    const std::vector<std::size_t> normals = compact(numbers.normal);
    for (std::size_t i = 1; i < part.instances.size(); ++i) {
        const NormalTransform normal_transform(part.instances[i]);
        put(text, FMT_COMPILE("o {} {}\n"), one_line(part.name), i + 1);
        for (const std::size_t p : points) {
            print_point(text, Vec3d(part.instances[i] * Vec4d(mesh.positions[p - 1], 1.0)),
                        colors.empty() ? nullptr : &colors[p - 1]);
        }
        for (const std::size_t n : normals) {
            print_normal(text, normal_transform(lines.normals[n - 1]));
        }
        print_faces(text, numbers, offsets, normal_transform.mirrors());
        offsets.point += points.size();
        offsets.normal += normals.size();
    }
}

ObjText obj_text(const SceneContent& content, const Mesh& mesh, std::span<const Vec3f> normals,
                 const std::string& mtl_name, const std::string& material) {
    const CornerLines lines = corner_lines(content.atlas, normals);
    const std::vector<Vec4f> colors = shown_colors(content, mesh);
    ObjText text;
    put(text, FMT_COMPILE("# Burl " BURL_VERSION "\nmtllib {}\nusemtl {}\n"), mtl_name, material);
    for (std::size_t p = 0; p < mesh.positions.size(); ++p)
        print_point(text, mesh.positions[p], colors.empty() ? nullptr : &colors[p]);
    text.append(lines.text);
    for (const Vec3f& n : lines.normals) print_normal(text, n);
    for (const Part& part : mesh.parts) {
        put(text, FMT_COMPILE("o {}\n"), one_line(part.name.empty() ? mesh.name : part.name));
        print_faces(text, face_numbers(mesh, part, lines), {}, false);
    }
    Offsets offsets{mesh.positions.size(), lines.normals.size()};
    for (const Part& part : mesh.parts) {
        if (part.instances.size() > 1) print_copies(text, mesh, part, lines, colors, offsets);
    }
    return text;
}

/// The lines that viewers without MTL's extension read, in the measures of Blender's own exporter:
/// the specular level, half of which is its 1, and an exponent of 1000 (1 - roughness)^2. Blender's
/// importers take `Ks 0` for no reflection, and a missing `Ns` for roughness 1. The exponent is at
/// least 10, since Phong's highlight of exponent 0 covers everything.
std::string mtl_highlight(const Material& material) {
    const double level = 0.5 * material.specular, smooth = 1.0 - material.roughness;
    return fmt::format("Ks {0:.4g} {0:.4g} {0:.4g}\nNs {1:.4g}\nillum 2\n", level,
                       std::max(10.0, 1000.0 * smooth * smooth));
}

/// The lines of a normal map: `norm`, and `map_Bump`, which Blender takes for a normal map of the
/// strength that -bm says. Godot reads map_bump, in small letters only, and no options.
std::string mtl_normals(const SceneContent& content) {
    const auto& normals = content.options.normals;
    if (!normals || !normals->tangent_space) return "";
    const std::string file =
        file_name(normal_map_path(content.path, content.options.coding.format));
    return fmt::format("norm {0}\nmap_Bump -bm 1 {0}\n", file);
}

/// The lines of the material besides its base colour and normals, by the extension of MTL for
/// physically based rendering that Blender, Clara.io and Assimp read; none for a material without
/// anything of its own.
std::string mtl_material(const SceneContent& content) {
    const Material& m = content.options.material;
    const auto& pictures = content.options.pictures;
    const TextureFormat format = content.options.coding.format;
    std::string text;
    const auto packed = std::ranges::find_if(pictures, [](const ExportPicture& picture) {
        return picture.name == "orm" || picture.name == "mask";
    });
    if (packed != pictures.end())
        text += fmt::format("# roughness and metallic: {}\n",
                            file_name(picture_path(content.path, packed->name, format)));
    else if (m != Material{} || !pictures.empty())
        text += fmt::format("Pr {}\nPm {}\n", m.roughness, m.metallic);
    if (m.clearcoat != 0.0)
        text += fmt::format("Pc {}\nPcr {}\n", m.clearcoat, m.clearcoat_roughness);
    if (m.ior != 1.5) text += fmt::format("Ni {}\n", m.ior);
    if (m.emissive != Rgb8{}) {
        const Vec3d light = m.emissive_strength * linear_light(m.emissive);
        text += fmt::format("Ke {} {} {}\n", light.x, light.y, light.z);
    }
    constexpr std::array<std::array<const char*, 2>, 4> maps{{{"roughness", "map_Pr"},
                                                              {"metallic", "map_Pm"},
                                                              {"emissive", "map_Ke"},
                                                              {"sheen", "map_Ps"}}};
    for (const ExportPicture& picture : pictures)
        for (const auto& [name, line] : maps)
            if (picture.name == name)
                text += fmt::format("{} {}\n", line,
                                    file_name(picture_path(content.path, picture.name, format)));
    if (has_alpha(content.image))
        text += fmt::format("map_d -imfchan m {}\n",
                            file_name(path_beside(content.path, extension_of(format))));
    return text;
}

/// The material's name in one word, unlike those of faces that keep theirs.
std::string obj_material_name(const SceneContent& content) {
    std::string wanted = without_spaces(material_name(content));
    if (!content.options.obj) return wanted;
    const std::vector<std::string>& others = content.options.obj->source.materials;
    std::string name = wanted;
    for (int k = 2; std::ranges::find(others, name) != others.end(); ++k)
        name = fmt::format("{}_{}", wanted, k);
    return name;
}

/// Writes the files of a mesh with these normals, one per triangle corner.
std::vector<AtomicFile> write_files(const SceneContent& content, const Mesh& mesh,
                                    std::span<const Vec3f> normals) {
    const std::string texture =
        path_beside(content.path, extension_of(content.options.coding.format));
    const std::string library = path_beside(content.path, ".mtl");
    const std::string name = obj_material_name(content);
    const ObjText text = content.options.obj
                             ? kept_obj_text(content, mesh, normals, file_name(library), name)
                             : obj_text(content, mesh, normals, file_name(library), name);
    std::string material = fmt::format("newmtl {}\nKa 0 0 0\nKd 1 1 1\n{}", name,
                                       mtl_highlight(content.options.material));
    if (content.options.vertex_colors.empty())
        material += fmt::format("map_Kd {}\n", file_name(texture));
    material += mtl_normals(content) + mtl_material(content);
    std::vector<AtomicFile> files;
    add_images(files, content, texture);
    files.emplace_back(library).write(material);
    files.emplace_back(content.path).write(std::string_view(text.data(), text.size()));
    return files;
}

/// The image with alpha 0 or 1: MTL has no cutoff.
BakedImage cut(BakedImage image, double cutoff) {
    const auto cut_pixels = [cutoff]<class Pixel>(Image<Pixel>& pixels) {
        if constexpr (std::is_same_v<Pixel, Rgba8> || std::is_same_v<Pixel, Rgba16>) {
            constexpr auto full = std::numeric_limits<decltype(Pixel::a)>::max();
            pixels = converted<Pixel>(pixels, [&](Pixel p) {
                p.a = double(p.a) >= cutoff * double(full) ? full : decltype(Pixel::a)(0);
                return p;
            });
        }
    };
    std::visit(cut_pixels, image);
    return image;
}

/// The material as a MaterialX document has it. The alpha of a mask is 0 or 1 in the picture.
materialx::BakedSurface surface_of(const SceneContent& content) {
    const ExportOptions& options = content.options;
    const TextureFormat format = options.coding.format;
    materialx::BakedSurface surface{.name = material_name(content), .material = options.material};
    surface.color = file_name(path_beside(content.path, extension_of(format)));
    surface.has_alpha = has_alpha(content.image);
    if (options.material.alpha == AlphaMode::mask) surface.alpha_cutoff = 0.5;
    if (options.normals) {
        surface.normals = file_name(normal_map_path(content.path, format));
        surface.tangent_space = options.normals->tangent_space;
    }
    for (const ExportPicture& picture : options.pictures)
        surface.pictures.emplace_back(picture.name,
                                      file_name(picture_path(content.path, picture.name, format)));
    surface.closest = content.atlas.options.overscan == Overscan::nearest;
    return surface;
}

std::vector<AtomicFile> write_content(const SceneContent& content) {
    const ShownMesh shown = shown_mesh(content);
    return write_files(content, shown.of(content), shown.normals);
}

}  // namespace

std::vector<AtomicFile> write_mtlx(const SceneContent& content) {
    std::vector<AtomicFile> files = write_obj({path_beside(content.path, ".obj"), content.mesh,
                                               content.atlas, content.image, content.options});
    const materialx::SurfaceDocument document = materialx::surface_document(surface_of(content));
    if (!document.lost.empty() && content.options.tell) content.options.tell(document.lost);
    files.emplace_back(content.path).write(document.text);
    return files;
}

std::vector<AtomicFile> write_obj(const SceneContent& content) {
    const Material& material = content.options.material;
    if (material.alpha != AlphaMode::mask || !has_alpha(content.image))
        return write_content(content);
    ExportOptions options = content.options;
    for (BakedImage& level : options.levels) level = cut(std::move(level), material.alpha_cutoff);
    const BakedImage image = cut(content.image, material.alpha_cutoff);
    return write_content({content.path, content.mesh, content.atlas, image, options});
}

}  // namespace burl
