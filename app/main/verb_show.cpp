// `burl show`: a recipe for people, with its controls, and its JSON.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/base/json_text.h"
#include "app/base/messages.h"
#include "app/main/verbs.h"
#include "app/materialx/write/recipe.h"
#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/images.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/presets.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "atlas/base/named_files.h"

namespace burl {

namespace {

struct ShowCommand {
    std::string recipe;
    bool json = false, materialx = false;
    NamedFiles named = NamedFiles::below;
};

/// A line of the table of controls.
struct ControlLine {
    std::string name, value, range, about;
};

ControlLine line_of(const ControlState& state) {
    ControlLine line{state.control.name, "", "", state.control.about};
    line.value = state.value.is_string() ? state.value.get<std::string>()
                                         : fmt::format("{:.6g}", state.value.get<double>());
    if (const auto& range = state.control.range)
        line.range = fmt::format("{} to {}", (*range)[0], (*range)[1]);
    return line;
}

/// The number of characters of UTF-8, as far as columns are concerned.
std::size_t width_of(const std::string& text) {
    return std::size_t(
        std::ranges::count_if(text, [](char c) { return (std::uint8_t(c) & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(width - std::min(width, width_of(text)), ' ');
}

void print_controls(const std::vector<ControlState>& states) {
    std::vector<ControlLine> lines{{"control", "value", "range", "about"}};
    for (const ControlState& state : states) lines.push_back(line_of(state));
    const auto widest = [&](std::string ControlLine::*column) {
        std::size_t width = 0;
        for (const ControlLine& line : lines) width = std::max(width, width_of(line.*column));
        return width + 2;
    };
    const std::size_t names = widest(&ControlLine::name), values = widest(&ControlLine::value),
                      ranges = widest(&ControlLine::range);
    for (const ControlLine& line : lines) {
        std::string text = padded(line.name, names) + padded(line.value, values) +
                           padded(line.range, ranges) + line.about;
        print_line(text.substr(0, text.find_last_not_of(' ') + 1));
    }
    print_line("");
}

/// Prints the text line by line, so that a terminal obeys nothing in it.
void print_lines(const std::string& text) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        print_line(text.substr(begin, end - begin));
        begin = end + 1;
    }
}

void print_recipe(const Recipe& recipe, const std::string& path) {
    print_line(recipe.name.empty() ? std::filesystem::path(path).stem().string() : recipe.name);
    if (!recipe.group.empty()) print_line("group: " + recipe.group);
    if (!recipe.about.empty()) print_line(recipe.about);
    print_line("");
    const std::vector<ControlState> states = control_states(slider_json(recipe));
    if (!states.empty()) print_controls(states);
}

/// Prints the recipe as a document of MaterialX, of a mesh whose coordinates are the solid's.
void print_materialx(const Recipe& recipe, const std::string& path) {
    const materialx::RecipeDocument document = materialx::recipe_document(recipe, {});
    for (const std::string& note : document.notes) warn(fmt::format("{}: {}", path, note));
    fmt::print("{}", document.text);
}

void run_show(const ShowCommand& command) {
    const auto [text, losses, origin] = recipe_text(command.recipe);
    RecipeImages images(ImageLimits{.named = command.named});
    const Recipe recipe = parse_recipe(text, origin, {}, images);
    for (const std::string& loss : losses) warn(loss);
    if (command.json) {
        fmt::print("{}{}", text, text.ends_with('\n') ? "" : "\n");
        return;
    }
    if (command.materialx) return print_materialx(recipe, command.recipe);
    print_recipe(recipe, command.recipe);
    print_lines(text);
}

}  // namespace

void add_show(CLI::App& program) {
    auto* verb = program.add_subcommand(
        "show", "Show a recipe or material: what it is, its controls, and its JSON");
    auto command = std::make_shared<ShowCommand>();
    verb->add_option("recipe", command->recipe,
                     "Name of a recipe or material, or a .json or .mtlx file")
        ->required();
    verb->add_flag("--json", command->json,
                   "Print the JSON alone, as it was written, or made of a .mtlx");
    verb->add_flag("--materialx", command->materialx,
                   "Print a MaterialX document of the same material: its nodes as a node graph")
        ->excludes("--json");
    verb->add_flag_callback(
        "--allow-outside", [command] { command->named = NamedFiles::anywhere; },
        "Read images that lie outside of the recipe's own folder");
    verb->callback([command] { run_show(*command); });
}

}  // namespace burl
