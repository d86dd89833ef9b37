#include "app/options/command_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/messages.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/parameters.h"
#include "app/recipe/spelling.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"
#include "atlas/mesh/choose_faces.h"
#include "atlas/read/obj_source.h"

namespace burl {

namespace {

/// The words as a sentence has them: "a, b or c".
std::string alternatives(std::span<const std::string_view> words) {
    if (words.size() < 2) return fmt::format("{}", fmt::join(words, ""));
    return fmt::format("{} or {}", fmt::join(words.first(words.size() - 1), ", "), words.back());
}

/// The long name of an option: "--size" for "-s,--size".
std::string_view long_name(std::string_view option) {
    return option.substr(option.rfind("--"));
}

/// Adds the edits of --filter, KIND or supersample:N. Throws Error(usage) where another kind has a
/// number of samples.
void append_filter(const std::string& text, std::vector<RecipeEdit>& edits) {
    const std::size_t colon = text.find(':');
    const std::string option = "--filter " + text;
    edits.push_back({option, "filter.kind", text.substr(0, colon)});
    if (colon == std::string::npos) return;
    if (!text.starts_with("supersample:"))
        throw Error(ExitCode::usage,
                    fmt::format("{}: only supersample takes a number of samples", option));
    edits.push_back({option, "filter.samples", text.substr(colon + 1)});
}

void append_precision(const std::string& text, std::vector<RecipeEdit>& edits) {
    const FixedFormat format = parse_precision(text).format;
    const std::string option = "--precision " + text;
    edits.push_back({option, "precision.kind", text.substr(0, text.find(':'))});
    if (!text.starts_with("fixed")) return;
    edits.push_back({option, "precision.integer_bits", std::to_string(format.integer_bits)});
    edits.push_back({option, "precision.fraction_bits", std::to_string(format.fraction_bits)});
}

/// Throws Error(usage) where two edits set one number, since the first would have no effect.
void check_said_once(const std::vector<RecipeEdit>& edits) {
    for (std::size_t i = 0; i < edits.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (respelled_path(edits[i].path) == respelled_path(edits[k].path))
                throw Error(ExitCode::usage,
                            fmt::format("{} and {} say the same thing; give one of them",
                                        edits[i].said, edits[k].said));
}

/// Throws Error(usage) for an edit of a number that the recipe's keys move, since it would have no
/// effect.
void check_not_keyed(const std::vector<RecipeEdit>& edits, const KeyedAnimation& animation) {
    for (const KeyTrack& track : animation.tracks)
        for (const RecipeEdit& edit : edits)
            if (respelled_path(edit.path) == track.path)
                throw Error(ExitCode::usage,
                            fmt::format("{} does nothing: the recipe has keys for that number; "
                                        "leave it out, or change its \"animation\"",
                                        edit.said));
}

/// The error of load_recipe(), with the option that the user gave in place of --set.
Error with_option(const Error& error, const std::vector<RecipeEdit>& edits) {
    const std::string sentence = error.what();
    for (const RecipeEdit& edit : edits) {
        const std::string front = fmt::format("--set {}: ", edit.setting());
        if (sentence.starts_with(front))
            return Error(error.code(),
                         fmt::format("{}: {}", edit.said, sentence.substr(front.size())));
    }
    return error;
}

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

/// The word of --no-skip that stands for all skip_names.
constexpr const char* all_skips = "all";

constexpr double megabyte = 1024.0 * 1024.0, usual_megabytes = 1024.0, most_megabytes = 1 << 20;

}  // namespace

void RecipeOptions::add_recipe(CLI::App& verb) {
    verb.add_option("-r,--recipe", recipe, "Name of a preset or material, or recipe file (.json)")
        ->capture_default_str();
    add_settings(verb);
}

void RecipeOptions::add_settings(CLI::App& verb) {
    verb.add_option("--set", settings,
                    "Edit of the recipe, PATH=VALUE or CONTROL=VALUE; may be repeated")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb.add_option("--time", time, "Of a recipe with keys: its state after so many seconds")
        ->check(in_range(0.0, 3600.0));
}

void RecipeOptions::add_parameters(CLI::App& verb) {
    for (const RecipeParameter& parameter : burl::parameters())
        if (!parameter.use.option.empty()) parameters.push_back({&parameter});
    // In --help the texture's size comes after all that says how it is laid out.
    std::ranges::stable_partition(parameters, [](const ParameterOption& option) {
        return option.parameter->path != "atlas.size";
    });
    for (auto& [parameter, value] : parameters)
        verb.add_option(std::string(parameter->use.option), value,
                        fmt::format(fmt::runtime(parameter->use.help),
                                    alternatives(split_choices(parameter->choices))));
}

void RecipeOptions::add_filter(CLI::App& verb) {
    verb.add_option("--filter", filter,
                    fmt::format("Texel filter: {}:N", alternatives(enum_names<FilterKind>)));
}

void RecipeOptions::add_precision(CLI::App& verb, const std::string& otherwise) {
    verb.add_option("--precision", precision,
                    fmt::format("Arithmetic of the texture: float32, float64, or fixed:I.F, "
                                "integers with I bits before the point and F after it; left out: "
                                "the recipe's, or else {}",
                                otherwise));
}

std::optional<std::string> RecipeOptions::given(std::string_view path) const {
    for (const auto& [parameter, value] : parameters)
        if (parameter->path == path) return value;
    return {};
}

std::vector<RecipeEdit> RecipeOptions::edits() const {
    std::vector<RecipeEdit> edits;
    for (const std::string& setting : settings) {
        const std::size_t equals = std::min(setting.find('='), setting.size());
        edits.push_back({"--set " + setting, setting.substr(0, equals),
                         setting.substr(std::min(equals + 1, setting.size()))});
    }
    for (const auto& [parameter, value] : parameters)
        if (value)
            edits.push_back({fmt::format("{} {}", long_name(parameter->use.option), *value),
                             std::string(parameter->path), *value});
    if (filter) append_filter(*filter, edits);
    if (precision) append_precision(*precision, edits);
    return edits;
}

Recipe RecipeOptions::load_keyed() const {
    const std::vector<RecipeEdit> all = edits();
    check_said_once(all);
    std::vector<std::string> texts = settings;
    for (std::size_t i = settings.size(); i < all.size(); ++i) texts.push_back(all[i].setting());
    try {
        Recipe keyed = load_recipe(recipe, texts, *images);
        check_not_keyed(all, keyed.animation);
        return keyed;
    } catch (const Error& error) {
        throw with_option(error, all);
    }
}

Recipe RecipeOptions::load() const {
    const Recipe keyed = load_keyed();
    if (time && keyed.animation.tracks.empty())
        throw Error(
            ExitCode::usage,
            fmt::format("--time: the recipe {} has no keys over time; leave it out", recipe));
    return recipe_at(keyed, time.value_or(0.0));
}

Precision parse_precision(const std::string& text) {
    const auto kind = enum_named<PrecisionKind>(text);
    if (kind && *kind != PrecisionKind::fixed) return {kind, {}};
    Precision precision{PrecisionKind::fixed, {}};
    auto& [integer, fraction] = precision.format;
    const std::string_view begin = "fixed:";
    const char *const first = text.data() + std::min(begin.size(), text.size()), *const last =
                                                                                     text.data() +
                                                                                     text.size();
    const auto before = std::from_chars(first, last, integer);
    const bool dot = before.ec == std::errc() && before.ptr != last && *before.ptr == '.';
    const auto after = std::from_chars(dot ? before.ptr + 1 : last, last, fraction);
    if (!text.starts_with(begin) || !dot || after.ec != std::errc() || after.ptr != last ||
        integer < 1 || integer > 16 || fraction < 2 || fraction > 16)
        throw Error(ExitCode::usage,
                    fmt::format("--precision {}: must be float32, float64, or fixed:I.F with 1 to "
                                "16 bits before the point and 2 to 16 after it, as fixed:8.8",
                                text));
    return precision;
}

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

namespace {

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

Mesh MeshOptions::load(const std::string& path) const {
    check_choice(read.choice, path);
    if (read.unshare_instances && (is_sample_mesh(path) || !has_gltf_extension(path)))
        throw Error(ExitCode::usage,
                    fmt::format("--unshare-instances: {} is no glTF and has no instances; leave it "
                                "out",
                                path));
    Mesh mesh = is_sample_mesh(path) ? sample_mesh(path, read) : read_mesh(path, read);
    const bool gltf = !is_sample_mesh(path) && has_gltf_extension(path);
    if (!gltf && !read.choice.materials.empty())
        mesh = of_materials(path, mesh, read.choice.materials);
    for (const std::string& sentence : sentences_of(mesh.notes))
        warn(fmt::format("{}: {}", path, sentence));
    return framed(std::move(mesh), frame_transform(frame));
}

MeshPose MeshOptions::pose(const std::string& mesh, const std::string& pose) const {
    return framed(load_pose(mesh, pose, read), frame_transform(frame));
}

void add_pose(CLI::App& verb, std::string& pose) {
    verb.add_option("--pose", pose,
                    "Another shape of the mesh, to which its texture sticks: a mesh file with the "
                    "same faces, or a pose of the mesh's own file: a morph target, a moment of an "
                    "animation (NAME@SECONDS) or \"nodes\"; pose.weight says how far");
}

CLI::Validator in_range(double low, double high) {
    const std::string bounds = fmt::format("{:.3g} to {:.3g}", low, high);
    return {[=](std::string& text) {
                double value = 0.0;
                const bool fits =
                    CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
                return fits ? "" : fmt::format("{} is not a number from {}", text, bounds);
            },
            bounds};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
    const CLI::Validator member = CLI::IsMember(words);
    return {[=](std::string& text) {
                std::string problem = member(text);
                if (problem.empty()) return problem;
                const std::vector<std::string_view> views(words.begin(), words.end());
                const std::string_view nearest = nearest_word(text, views);
                if (!nearest.empty()) problem += fmt::format("; did you mean {}?", nearest);
                return problem;
            },
            member.get_description()};
}

void add_threads(CLI::App& verb, int& threads) {
    verb.add_option("-j,--threads", threads,
                    "Threads to use, 0 for all; the result never depends on it")
        ->check(CLI::Range(0, 1024));
}

void EconomyOptions::add_skips(CLI::App& verb) {
    std::vector<std::string> words(skip_names.begin(), skip_names.end());
    words.emplace_back(all_skips);
    verb.add_option("--no-skip", forbidden,
                    "Do work that is otherwise left out, by its name, or all; may be repeated. "
                    "The result is the same")
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->check(one_of(words));
}

void EconomyOptions::add_cache(CLI::App& verb) {
    verb.add_option("--cache", cache_megabytes,
                    "Memory for what one texture leaves to the next, in MB (1024 for --frames, "
                    "else 0)")
        ->check(in_range(0.0, most_megabytes));
}

Skips EconomyOptions::skips() const {
    Skips skips;
    for (std::size_t k = 0; k < skip_names.size(); ++k)
        if (std::ranges::any_of(forbidden, [&](const std::string& word) {
                return word == skip_names[k] || word == all_skips;
            }))
            skips.forbid(Skip(k));
    return skips;
}

std::size_t EconomyOptions::cache_bytes(bool several) const {
    return std::size_t(cache_megabytes.value_or(several ? usual_megabytes : 0.0) * megabyte);
}

}  // namespace burl
