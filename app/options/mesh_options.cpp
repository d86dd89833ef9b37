// The options about a mesh's file, and how it is read with them.
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/messages.h"
#include "app/options/command_options.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"
#include "atlas/mesh/choose_faces.h"
#include "atlas/read/obj_source.h"

namespace burl {

namespace {

/// Parses the angles X,Y,Z of --rotate, each within [-360, 360]. Throws Error(usage).
Vec3d parse_turns(const std::string& text) {
    Vec3d degrees(0.0);
    const std::vector<std::string> words = CLI::detail::split(text, ',');
    bool right = words.size() == 3;
    for (int k = 0; right && k < 3; ++k)
        right = CLI::detail::lexical_cast(words[std::size_t(k)], degrees[k]) &&
                std::abs(degrees[k]) <= 360.0;
    if (!right)
        throw Error(ExitCode::usage,
                    fmt::format("--rotate {}: write the degrees about x, y and z, each from -360 "
                                "to 360, as 90,0,-45",
                                text));
    return degrees;
}

/// The faces of the mesh whose material one of the patterns fits. Throws Error(usage) where one
/// fits none.
Mesh of_materials(const std::string& path, const Mesh& mesh,
                  const std::vector<std::string>& patterns) {
    const ObjSource source = read_obj_source(mesh_bytes(path));
    const std::vector<char> chosen = faces_of_materials(source, patterns);
    if (mesh.triangles.empty() || mesh.source_faces.back() >= chosen.size())
        throw Error(ExitCode::runtime,
                    fmt::format("{}: the file has changed while it was used; try again", path));
    return with_faces(mesh, chosen);
}

/// Throws Error(usage) where names are chosen that the mesh's format does not have.
void check_choice(const GltfChoice& choice, const std::string& path) {
    const bool gltf = !is_sample_mesh(path) && has_gltf_extension(path);
    const bool obj = is_sample_mesh(path) || lower_extension(path) == ".obj";
    if (!gltf && (!choice.meshes.empty() || !choice.nodes.empty()))
        throw Error(ExitCode::usage,
                    fmt::format("--mesh and --node choose parts of a glTF, and {} is none; leave "
                                "them out",
                                path));
    if (!gltf && !obj && !choice.materials.empty())
        throw Error(ExitCode::usage,
                    fmt::format("--material chooses by the materials of an OBJ or glTF, and {} is "
                                "neither; leave it out",
                                path));
}

}  // namespace

void MeshOptions::add(CLI::App& verb) {
    verb.add_option("--weld", read.weld, "Weld points closer than this times the longest side")
        ->check(in_range(0.0, 0.1));
    verb.add_flag("--unshare-instances", read.unshare_instances,
                  "Bake each glTF instance by itself, in scene space");
    verb.add_option("--material", read.choice.materials,
                    "Faces of an OBJ or glTF to texture, by the names of their materials, with * "
                    "and ?; may be repeated; left out: all")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    add_frame(verb);
}

void MeshOptions::add_frame(CLI::App& verb) {
    verb.add_option("--up", frame.up,
                    "Axis of the mesh's file that points up: y (glTF), z (scans, CAD, Blender), "
                    "-z, x, -x or -y; the mesh is turned so that it is y")
        ->check(one_of({up_axes.begin(), up_axes.end()}))
        ->capture_default_str();
    verb.add_option_function<std::string>(
        "--rotate", [this](const std::string& text) { frame.rotate = parse_turns(text); },
        "Turn the mesh, after --up, by these degrees about x, then y, then z: X,Y,Z");
    verb.add_option("--scale", frame.scale, "Factor of the mesh's coordinates")
        ->check(in_range(1e-9, 1e9));
    verb.add_option_function<std::string>(
            "--units",
            [this](const std::string& word) { frame.units = enum_named<LengthUnit>(word); },
            "Length that 1 of the mesh's file is: mm, cm or m; the mesh comes out in metres")
        ->check(one_of({enum_names<LengthUnit>.begin(), enum_names<LengthUnit>.end()}));
}

void MeshOptions::add_uv_set(CLI::App& verb) {
    verb.add_option("--uv-set", read.uv_set,
                    "Which texture coordinates of a glTF are read: N of its TEXCOORD_N (default 0)")
        ->check(CLI::Range(0, 15));
}

void MeshOptions::add_choice(CLI::App& verb) {
    // Manifests of `burl batch` call the mesh's file "mesh".
    verb.add_option("--only-mesh,--mesh", read.choice.meshes,
                    "Meshes of a glTF to texture, by their names, with * and ?; may be repeated")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb.add_option("--node", read.choice.nodes,
                    "Nodes of a glTF to texture, with all below them, in the same way")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void MeshOptions::check(const std::string& path) const {
    check_choice(read.choice, path);
    if (read.unshare_instances && (is_sample_mesh(path) || !has_gltf_extension(path)))
        throw Error(ExitCode::usage,
                    fmt::format("--unshare-instances: {} is no glTF and has no instances; leave it "
                                "out",
                                path));
    if (read.uv_set > 0 && (is_sample_mesh(path) || !has_gltf_extension(path)))
        throw Error(ExitCode::usage,
                    fmt::format("--uv-set: {} is no glTF and has one set of texture coordinates at "
                                "most; leave it out",
                                path));
}

Mesh MeshOptions::load(const std::string& path) const {
    check(path);
    Mesh mesh = is_sample_mesh(path) ? sample_mesh(path, read) : read_mesh(path, read);
    if (read.uv_set > 0 && mesh.corners.uvs.empty())
        throw Error(ExitCode::usage,
                    fmt::format("--uv-set {0}: {1} has no TEXCOORD_{0}; name a set "
                                "that it has, or leave it out",
                                read.uv_set, path));
    const bool gltf = !is_sample_mesh(path) && has_gltf_extension(path);
    if (!gltf && !read.choice.materials.empty())
        mesh = of_materials(path, mesh, read.choice.materials);
    for (const std::string& sentence : sentences_of(mesh.notes))
        warn(fmt::format("{}: {}", path, sentence));
    return framed(std::move(mesh), frame);
}

MeshPose MeshOptions::pose(const std::string& mesh, const std::string& pose) const {
    return framed(load_pose(mesh, pose, read), frame);
}

}  // namespace burl
