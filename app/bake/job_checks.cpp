// Checks of a bake: its files, the format of its pictures, and displacement, against what else the
// command asks for.
#include "app/bake/job.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/bake/shared_pictures.h"
#include "app/bake/up_to_date.h"
#include "app/base/messages.h"
#include "app/export/command_files.h"
#include "app/pipeline/material.h"
#include "app/recipe/recipe_cost.h"
#include "atlas/base/error.h"

namespace burl {

/// Throws Error if an output would replace a file that is read or another output.
void BakeJob::check_files(const std::vector<std::string>& paths) const {
    check_scene_name(command_.out);
    CommandFiles files;
    if (command_.makes_folders) files.allow_new_folders();
    files.read(inputs_);
    for (const std::string& path : outputs(paths, plan_.levels.count))
        files.write(path, path == command_.solid_map ? ".exr" : "");
    if (!command_.report.empty() && command_.report != "-") files.write(command_.report);
    files.write(record_path(command_.out));
}

/// Throws Error if a file of the UDIM tiles at the paths is one that another bake of the batch
/// reads or writes.
void BakeJob::check_tiles(const std::vector<std::string>& paths) const {
    if (!batch_files_) return;
    for (const std::string& path : paths)
        for (const std::string& file : paths_of(path, plan_.levels.count))
            batch_files_->check(file);
}

/// Throws Error(usage) for a mask that is named twice, or as a picture of the material is.
void BakeJob::check_masks() const {
    const std::vector<std::string> pictures = picture_names(recipes_of_atlas(), plan_.material());
    for (const std::string& mask : command_.channels) {
        if (std::ranges::count(command_.channels, mask) > 1)
            throw Error(ExitCode::usage, fmt::format("--channels: {} is there twice", mask));
        if (std::ranges::count(pictures, mask) > 0)
            throw Error(ExitCode::usage,
                        fmt::format("--channels: the recipe's own {0} is the picture of that name; "
                                    "leave {0} out, or pack the material otherwise (--pack)",
                                    mask));
    }
}

/// Throws Error(usage) where the output holds no strips.
void BakeJob::check_strips() const {
    if (command_.strips && !holds_strips(command_.out))
        throw Error(ExitCode::usage,
                    fmt::format("{}: --strips: only .glb, .gltf and .ply hold triangle strips; "
                                "write one of these, or leave it out",
                                command_.out));
}

/// Throws Error(usage) for options of pictures, and for edits of a recipe that moves nothing, where
/// the output is the surface alone. That it has no colour is told as a loss.
void BakeJob::check_bare_surface() const {
    const BakeCommand& c = command_;
    const bool beside = !c.channels.empty() || !c.solid_map.empty() || !c.emitted_glsl.empty();
    if (!holds_mesh(c.out) || holds_colors(c.out) || beside) return;
    const auto refuse = [&](const std::string& option, const char* why) {
        throw Error(ExitCode::usage,
                    fmt::format("{}: {} does nothing: {}; leave it out", c.out, option, why));
    };
    const std::array<std::pair<bool, const char*>, 9> of_pictures{{
        {!c.levels.empty(), "--levels"},
        {c.compress.has_value(), "--compress"},
        {c.recipe.filter.has_value(), "--filter"},
        {c.recipe.precision.has_value(), "--precision"},
        {c.kernel != "auto", "--kernel"},
        {c.synth != "host", "--synth"},
        {c.depth.has_value(), "--depth"},
        {!c.packing.empty(), "--pack"},
        {!c.normals.empty() && c.normals != "none", "--normals"},
    }};
    for (const auto& [given, option] : of_pictures)
        if (given) refuse(option, "an .stl has no pictures");
    if (c.crease && !c.displace) refuse("--crease", "an .stl has normals of triangles alone");
    // A patch atlas cuts triangles.
    if (c.displace || recipe().atlas.kind == AtlasKind::patch) return;
    constexpr const char* why = "an .stl holds the surface alone, and there is no --displace";
    if (c.recipe.time) refuse("--time", why);
    for (const RecipeEdit& edit : c.recipe.edits())
        if (edit.said.starts_with("--set") && !edit.path.starts_with("atlas.") &&
            !edit.path.starts_with("pose."))
            refuse(edit.said, why);
}

/// Throws Error(usage) where the pictures cannot have what else is asked for.
void BakeJob::check_coding() const {
    const TextureFormat format = plan_.coding.format;
    const auto refuse = [&](std::string_view what, const std::string& why) {
        throw Error(ExitCode::usage,
                    fmt::format("{}: {} with pictures in {}: {}; write them in png", command_.out,
                                what, to_string(format), why));
    };
    if (command_.depth == 32 && plan_.kind != ImageKind::rgb_float)
        throw Error(ExitCode::usage,
                    fmt::format("{}: --depth 32: only an .exr has 32-bit floats", command_.out));
    const bool beside = has_normals() || !command_.channels.empty();
    const bool pictures = holds_mesh(command_.out)
                              ? holds_colors(command_.out) && !command_.vertex_colors
                              : plan_.kind != ImageKind::rgb_float || beside;
    if (!pictures && !command_.picture_format.empty())
        throw Error(ExitCode::usage,
                    fmt::format("{}: --picture-format does nothing: the output has no pictures; "
                                "leave it out",
                                command_.out));
    if (format == TextureFormat::png) return;
    if (plan_.depth == 16 && command_.depth != 32) refuse("--depth 16", "its codes have 8 bits");
    if (recipe().atlas.size > most_pixels(format) && plan_.kind != ImageKind::rgb_float)
        refuse(fmt::format("--size {}", recipe().atlas.size),
               fmt::format("it has at most {} pixels a side", most_pixels(format)));
    if (format != TextureFormat::jpeg || plan_.kind == ImageKind::rgb_float) return;
    if (any_transparent(recipes_of_atlas())) refuse("opacity", "it has no alpha");
    for (const MaterialPicture& picture : shared_material_pictures(
             recipes_of_atlas(), plan_.packing, plan_.material().rough_levels()))
        if (picture.components == 4)
            refuse(fmt::format("the picture {}", picture.name), "it has no alpha");
}

/// The option that works for a texture alone, not for the pictures of a material; empty: none.
std::string BakeJob::not_of(const Recipe& recipe) const {
    if (plan_.levels.rule.direct) return "--level-rule direct";
    if (command_.compress) return "--compress";
    if (command_.synth.starts_with("gl")) return "--synth " + command_.synth;
    if (recipe.precision.kind == PrecisionKind::fixed) return "--precision fixed";
    const bool any = command_.kernel == "auto" || command_.kernel == reference_kernel;
    return any ? "" : "--kernel " + command_.kernel;
}

/// Whether OpenGL cannot make what is asked for, whatever the recipe's colour: pictures of a
/// material, or an atlas that several recipes share.
bool BakeJob::needs_host() const {
    return !sharing_.empty() || std::ranges::any_of(*recipes_, [&](const Recipe& recipe) {
        return has_pictures(recipe, plan_.packing, plan_.material().rough_levels());
    });
}

/// Warns of the material's values that no file of the bake holds.
void BakeJob::warn_of_values() const {
    std::vector<std::string> pictures;
    if (!plan_.vertex_colors) pictures = picture_names(recipes_of_atlas(), plan_.material());
    const std::string values = values_not_held(recipe(), pictures, plan_.packing, command_.out);
    if (!values.empty()) warn(fmt::format("{}: {}", command_.out, values));
}

/// Warns of 16 bits in a glTF.
void BakeJob::warn_of_depth() const {
    if (plan_.depth != 16 || !is_gltf(command_.out) || command_.vertex_colors) return;
    warn(fmt::format("{}: {}; leave --depth 16 out unless the file goes elsewhere", command_.out,
                     deep_gltf_loss));
}

/// Warns of triangles that strips cannot hold.
void BakeJob::warn_of_strips(const StripCounts& counts) const {
    if (counts.left_out > 0)
        warn(fmt::format("{}: strips hold no triangle with a repeated corner; {} left out",
                         command_.out, counts.left_out));
}

/// The noises that the bake takes, those of all frames and of the document's further atlases; of
/// recipes that share one, those of the dearest. Points of --displace and --vertex-colors, which
/// --max-triangles bounds, are not counted.
double BakeJob::noises() const {
    double sum = 0.0;
    for (const BakeJob& other : others_) sum += other.noises();
    if (command_.vertex_colors) return sum;
    double levels = 1.0;
    for (std::uint32_t l = 1; plan_.levels.rule.direct && l <= plan_.levels.count && l < 16; ++l)
        levels += std::min(1.0, std::ldexp(double(plan_.levels.rule.samples), -2 * int(l)));
    if (!sharing_.empty()) {
        double most = 0.0;
        for (const Recipe& recipe : sharing_)
            most = std::max(most, noises_of_texture(recipe, has_normals()));
        return sum + levels * most;
    }
    for (const Recipe& recipe : *recipes_) sum += levels * noises_of_texture(recipe, has_normals());
    return sum;
}

/// Throws Error(usage) where --displace cannot be had with what else is asked for.
void BakeJob::check_displacement() const {
    if (!command_.displace) return;
    const auto refuse = [&](const char* why) {
        throw Error(ExitCode::usage, fmt::format("{}: --displace: {}", command_.out, why));
    };
    if (!holds_mesh(command_.out))
        refuse("a texture alone has no points to move; write .glb, .gltf or .obj, or leave it out");
    if (recipe().bump.empty())
        refuse("the recipe has no height; add material.height, or leave --displace out");
    if (has_normals())
        refuse("the normal map would show the same height once more; leave --normals out");
    if (!command_.pose.empty()) refuse("a pose has points of its own; leave one of the two out");
}

}  // namespace burl
