// Errors, versions, meshes and recipes.
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/base/version.h"
#include "app/kept/scene.h"
#include "app/library/guard.h"
#include "app/library/reported.h"
#include "app/library/states.h"
#include "app/library/version.h"
#include "app/pipeline/tasks.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/presets.h"
#include "app/surface/mesh_frame.h"
#include "app/surface/sample_meshes.h"
#include "atlas/file/file_extension.h"
#include "atlas/mesh/mesh_builder.h"
#include "procedural/numbers/simd_target.h"

namespace burl::library {

Error::Error(ErrorKind kind, const std::string& sentence)
    : std::runtime_error(sentence), kind_(kind) {}

Error::~Error() = default;

std::string without_dashes(std::string sentence) {
    const auto is_letter = [&](std::size_t at) {
        return at < sentence.size() && sentence[at] >= 'a' && sentence[at] <= 'z';
    };
    for (std::size_t at = 0; (at = sentence.find("--", at)) != std::string::npos; ++at)
        if ((at == 0 || sentence[at - 1] == ' ') && is_letter(at + 2)) sentence.erase(at, 2);
    return sentence;
}

std::string version() {
    return burl_version();
}

std::string simd() {
    return simd_level();
}

namespace {

/// The sentence of an error about a setting without the command line's option.
std::string without_option(const std::string& sentence) {
    for (const std::string_view option : {"--set: ", "--set "})
        if (sentence.starts_with(option)) return sentence.substr(option.size());
    return sentence;
}

/// Throws burl::Error(usage) unless the value is within the bounds.
void check_range(const char* name, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw burl::Error(ExitCode::usage,
                      fmt::format("{} {}: must be from {} to {}", name, value, low, high));
}

/// Throws burl::Error(usage) unless the sizes are those of arrays of a mesh.
void check_sizes(std::size_t positions, std::size_t triangles, std::size_t uvs) {
    const auto refuse = [](const std::string& sentence) {
        throw burl::Error(ExitCode::usage, sentence);
    };
    if (positions % 3 != 0)
        refuse(fmt::format("positions: {} numbers are not three per point", positions));
    if (triangles % 3 != 0 || triangles == 0)
        refuse(fmt::format("triangles: {} numbers are not three per triangle, of at least one",
                           triangles));
    if (uvs != 0 && uvs != 2 * triangles)
        refuse(fmt::format("uvs: {} numbers are not two per corner of {} triangles, which are {}",
                           uvs, triangles / 3, 2 * triangles));
}

/// Throws burl::Error(usage) for a number that is not finite or, for points, beyond meshes' range.
void check_finite(const char* name, std::span<const double> numbers, std::size_t in_row,
                  double most) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!(std::abs(numbers[i]) <= most))
            throw burl::Error(ExitCode::usage,
                              fmt::format("{}: row {} has {}, which is not finite or beyond {}",
                                          name, i / in_row, numbers[i], most));
}

PolygonSoup soup_of(std::span<const double> positions, std::span<const std::uint32_t> triangles,
                    std::span<const double> uvs) {
    check_sizes(positions.size(), triangles.size(), uvs.size());
    check_finite("positions", positions, 3, 1e100);
    check_finite("uvs", uvs, 2, 1e30);
    PolygonSoup soup;
    soup.points.reserve(positions.size() / 3);
    for (std::size_t i = 0; i < positions.size(); i += 3)
        soup.points.emplace_back(positions[i], positions[i + 1], positions[i + 2]);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (triangles[i] >= soup.points.size())
            throw burl::Error(
                ExitCode::usage,
                fmt::format("triangles: triangle {} refers to point {}, and there are "
                            "points 0 to {}",
                            i / 3, triangles[i], soup.points.size() - 1));
    soup.corners.assign(triangles.begin(), triangles.end());
    for (std::size_t i = 0; i < uvs.size(); i += 2) {
        soup.uvs.of_corner.push_back(std::uint32_t(i / 2));
        soup.uvs.values.emplace_back(uvs[i], uvs[i + 1]);
    }
    return soup;
}

Mesh::State read(const std::string& path, const MeshReading& reading, const std::stop_token& stop) {
    check_range("weld", reading.weld, 0.0, 0.1);
    check_range("scale", reading.scale, 1e-9, 1e9);
    check_range("uv_set", reading.uv_set, 0, 15);
    ReadOptions options;
    options.weld = reading.weld;
    options.uv_set = reading.uv_set;
    MeshFrame frame;
    frame.up = reading.up;
    frame.scale = reading.scale;
    const bool is_sample = is_sample_mesh(path);
    burl::Mesh mesh =
        framed(is_sample ? sample_mesh(path, options) : read_mesh(path, options, stop), frame);
    std::vector<std::string> losses;
    if (!is_sample && has_gltf_extension(path)) losses = losses_of_flat(path, mesh, "", false);
    return {std::move(mesh), path, std::move(losses)};
}

std::shared_ptr<const Recipe::State> state_of(const RecipeText& text) {
    burl::Recipe recipe = parse_recipe(text.json, text.origin);
    return std::make_shared<Recipe::State>(std::move(recipe), text.origin, text.losses);
}

}  // namespace

Mesh::Mesh(std::shared_ptr<const State> state) : state_(std::move(state)) {}

Mesh Mesh::read(const std::string& path, const MeshReading& reading) {
    const auto make = [&](const std::stop_token& stop, Course* course) {
        return guarded([&] {
            if (course) course->meter().begin(tasks::read);
            return Mesh(std::make_shared<State>(library::read(path, reading, stop)));
        });
    };
    return made_reported(reading.progress, make);
}

Mesh::Mesh(std::span<const double> positions, std::span<const std::uint32_t> triangles,
           std::span<const double> uvs, const std::string& name) {
    state_ = guarded([&] {
        return std::make_shared<State>(
            State{build_mesh(soup_of(positions, triangles, uvs), name), {}, {}});
    });
}

const std::string& Mesh::name() const {
    return state_->mesh.name;
}

std::span<const double> Mesh::positions() const {
    return numbers_of<double>(state_->mesh.positions);
}

std::span<const std::uint32_t> Mesh::triangles() const {
    return numbers_of<std::uint32_t>(state_->mesh.triangles);
}

std::span<const double> Mesh::uvs() const {
    return numbers_of<double>(state_->mesh.corners.uvs);
}

std::vector<std::string> Mesh::notes() const {
    return sentences_of(state_->mesh.notes);
}

Recipe::Recipe(std::shared_ptr<const State> state) : state_(std::move(state)) {}

Recipe Recipe::load(const std::string& path_or_preset) {
    return guarded([&] {
        RecipeText text = recipe_text(path_or_preset);
        burl::Recipe recipe = parse_recipe(text.json, text.origin);
        if (recipe.name.empty() && !names_preset(path_or_preset))
            recipe.name = std::filesystem::path(text.origin).stem().string();
        return Recipe(std::make_shared<State>(std::move(recipe), text.origin, text.losses));
    });
}

Recipe Recipe::parse(const std::string& json, const std::string& origin) {
    return guarded([&] { return Recipe(state_of({json, {}, origin})); });
}

std::vector<std::string> Recipe::names() {
    std::vector<std::string> names;
    for (const std::string_view name : preset_names()) names.emplace_back(name);
    for (const std::string_view name : material_names()) names.emplace_back(name);
    return names;
}

const std::string& Recipe::name() const {
    return state_->recipe.name;
}

std::string Recipe::to_json() const {
    return guarded([&] { return burl::to_json(state_->recipe); });
}

Recipe Recipe::set(const std::string& path, const std::string& value) const {
    return guarded([&] {
        try {
            burl::Recipe recipe =
                parse_recipe(burl::to_json(state_->recipe), state_->origin, {path + "=" + value});
            return Recipe(
                std::make_shared<State>(std::move(recipe), state_->origin, state_->notes));
        } catch (const burl::Error& error) {
            throw burl::Error(error.code(), without_option(error.what()));
        }
    });
}

Recipe Recipe::set(const std::string& path, double value) const {
    return set(path, fmt::format("{}", value));
}

Recipe Recipe::at(double seconds) const {
    return guarded([&] {
        if (!std::isfinite(seconds))
            throw burl::Error(ExitCode::usage, fmt::format("{} is no time in seconds", seconds));
        return Recipe(std::make_shared<State>(recipe_at(state_->recipe, seconds), state_->origin,
                                              state_->notes));
    });
}

std::vector<std::string> Recipe::notes() const {
    return state_->notes;
}

}  // namespace burl::library
