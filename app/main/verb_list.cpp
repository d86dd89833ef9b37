// `burl list`: the names that other verbs accept.
#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/direct/figures.h"
#include "app/gl/device/context.h"
#include "app/light/environment.h"
#include "app/main/verbs.h"
#include "app/measure/report.h"
#include "app/options/command_options.h"
#include "app/recipe/material_notes.h"
#include "app/recipe/parameters.h"
#include "app/recipe/preset_notes.h"
#include "app/recipe/presets.h"
#include "app/recipe/recipe.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/graph/table.h"
#include "procedural/noise/names.h"

namespace burl {

namespace {

struct Entry {
    std::string name, text;
    std::string group{};  ///< entries of a group follow one another; empty: none
};

/// Each atlas kind in a clause, in the order of AtlasKind.
constexpr auto atlas_texts = std::to_array<const char*>(
    {"every triangle the same shape (Carr & Hart 4.1)",
     "triangles sized by their area (Carr & Hart 4.2)",
     "triangles sized by their longest edge (Carr & Hart 4.2)",
     "pairs in a balanced quadtree of surface clusters (Carr & Hart 4.3)",
     "few patches on full rectangles, for any lookup",
     "nearly isometric charts, for any lookup (the default)",
     "the file's own texture coordinates"});
static_assert(atlas_texts.size() == enum_names<AtlasKind>.size());

Entry recipe_entry(std::string_view name) {
    const std::span<const PresetNote> notes = preset_notes();
    const auto note = std::ranges::find(notes, name, &PresetNote::name);
    return {std::string(name), note == notes.end() ? "" : std::string(note->about)};
}

Entry material_entry(const MaterialNote& note) {
    return {note.name, note.about, note.group};
}

/// A parameter as "number 0..10, default 1: what it does".
std::string describe(const Parameter& p) {
    std::string text(to_string(p.type));
    if (p.type == ParameterType::choice) text += fmt::format(" {}", p.choices);
    const bool ranged = p.type == ParameterType::number || p.type == ParameterType::integer ||
                        p.type == ParameterType::numbers;
    if (ranged) text += fmt::format(" {:g}..{:g}", p.low, p.high);
    if (!p.unit.empty()) text += fmt::format(" {}", p.unit);
    if (!p.default_value.empty()) text += fmt::format(", default {}", p.default_value);
    return fmt::format("{}: {}", text, p.tip);
}

/// A node type as "inputs, parameters: what it gives".
std::string describe(const NodeType& type) {
    std::vector<std::string_view> keys;
    for (const NodeInput& input : type.inputs()) keys.push_back(input.key);
    for (const Parameter& parameter : type.parameters()) keys.push_back(parameter.path);
    if (type.name == "constant") keys.push_back("value");
    if (type.name == "color_map") keys.insert(keys.end(), {"wrap", "stops"});
    if (type.name == "field") keys.insert(keys.end(), {"quadric", "noise"});
    return fmt::format("{}{}{}", fmt::join(keys, ", "), keys.empty() ? "" : ": ", type.text);
}

template <class All, class Make>
std::vector<Entry> entries(const All& all, const Make& entry) {
    std::vector<Entry> result;
    for (const auto& one : all) result.push_back(entry(one));
    return result;
}

std::vector<Entry> gl_entries(const std::string& platform) {
    const std::unique_ptr<GlContext> context = create_gl_context(platform);
    return entries(gl_facts(*context), [](const GlFact& fact) {
        return Entry{fact.name, fact.value};
    });
}

std::vector<Entry> entries_of(const std::string& what) {
    if (what == "recipes") return entries(preset_names(), recipe_entry);
    if (what == "materials") return entries(material_notes(), material_entry);
    if (what == "parameters")
        return entries(parameters(), [](const Parameter& parameter) {
            return Entry{std::string(parameter.path), describe(parameter)};
        });
    if (what == "meshes")
        return entries(sample_mesh_names(), [](const std::string& name) {
            return Entry{"sample:" + name, "a mesh the program brings"};
        });
    if (what == "figures")
        return entries(figures(), [](const Figure& f) { return Entry{f.name, f.shows}; });
    if (what == "environments")
        return entries(environment_notes(), [](const EnvironmentNote& note) {
            return Entry{std::string(note.name), std::string(note.sentence)};
        });
    if (what == "atlases") {
        std::vector<Entry> kinds;
        for (std::size_t k = 0; k < enum_names<AtlasKind>.size(); ++k)
            kinds.push_back({std::string(enum_names<AtlasKind>[k]), atlas_texts[k]});
        return kinds;
    }
    if (what == "noises")
        return entries(noise_kinds, [](const auto& kind) {
            return Entry{std::string(kind.name), std::string(kind.text)};
        });
    return entries(graph_table(), [](const NodeType& type) {
        return Entry{std::string(type.name), describe(type)};
    });
}

Json entry_json(const Entry& entry) {
    Json json{{"name", entry.name}, {"text", entry.text}};
    if (!entry.group.empty()) json["group"] = entry.group;
    return json;
}

void print_entries(const std::vector<Entry>& entries, bool json) {
    if (json) {
        Json list = Json::array();
        for (const Entry& entry : entries) list.push_back(entry_json(entry));
        fmt::print("{}\n", list.dump(2));
        return;
    }
    std::string group;
    for (const Entry& entry : entries) {
        if (entry.group != group) fmt::print("{}{}:\n", group.empty() ? "" : "\n", entry.group);
        group = entry.group;
        fmt::print("{}{:<32} {}\n", group.empty() ? "" : "  ", entry.name, entry.text);
    }
}

}  // namespace

void add_list(CLI::App& program) {
    auto* verb = program.add_subcommand("list",
                                        "List recipes, materials, meshes, atlases, noises, nodes, "
                                        "parameters, figures, environments, or this OpenGL");
    auto what = std::make_shared<std::string>();
    auto platform = std::make_shared<std::string>(gl_platforms()[0]);
    auto json = std::make_shared<bool>(false);
    const std::vector<std::string> topics{"recipes",      "materials", "meshes",     "atlases",
                                          "noises",       "nodes",     "parameters", "figures",
                                          "environments", "gl"};
    const std::string all = fmt::format("{}", fmt::join(topics, ", "));
    verb->add_option("what", *what, all)->check(one_of(topics));
    auto* gl = verb->add_option("--gl", *platform,
                                "gl: osmesa (software) or egl (a graphics "
                                "processor)")
                   ->capture_default_str();
    verb->add_flag("--json", *json, "Print JSON");
    verb->callback([what, platform, gl, json, all] {
        if (what->empty()) throw Error(ExitCode::usage, fmt::format("list what? {}", all));
        if (gl->count() > 0 && *what != "gl")
            throw Error(ExitCode::usage,
                        fmt::format("list {}: --gl does nothing there, leave it out", *what));
        print_entries(*what == "gl" ? gl_entries(*platform) : entries_of(*what), *json);
    });
}

}  // namespace burl
