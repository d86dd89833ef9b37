#include "app/options/input_limits.h"

#include <sys/resource.h>

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/options/command_options.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

/// With less, Embree waits for ever for memory that it is not given.
constexpr std::uint64_t least_memory = std::uint64_t(256) << 20U;

/// Noises that one core evaluates in an hour: 150 million a second (docs/reference/limits.md).
constexpr double noises_an_hour = 150e6 * 3600.0;

/// Has the system refuse this process more memory than `bytes`, whoever asks for it.
void limit_memory(std::uint64_t bytes) {
    if (bytes < least_memory)
        throw Error(ExitCode::usage, "--max-memory: 256M is the least with which Burl works");
    rlimit limit{};
    ::getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    if (::setrlimit(RLIMIT_DATA, &limit) != 0)
        throw Error(ExitCode::unsupported,
                    "--max-memory: the system does not limit memory; leave it out");
}

}  // namespace

void add_input_limits(CLI::App& verb, MeshOptions& meshes, RecipeOptions& recipe) {
    verb.add_flag_callback(
        "--allow-outside",
        [&] {
            meshes.read.named = NamedFiles::anywhere;
            recipe.images->limits.named = NamedFiles::anywhere;
        },
        "Read and write files that a file names outside of its own folder");
    verb.add_option("--max-triangles", meshes.read.most_triangles,
                    "Refuse a mesh of more triangles, instances and --displace included")
        ->check(CLI::Range(std::uint64_t(1), std::uint64_t(1) << 40))
        ->capture_default_str();
    verb.add_option_function<std::size_t>(
            "--max-image", [&](std::size_t side) { recipe.images->limits.side = side; },
            "Refuse an image of a recipe with a longer side in pixels, and images that have more "
            "than twice its square together, all sides rounded up to powers of two")
        ->check(CLI::Range(1, 65536))
        ->default_str(std::to_string(ImageLimits{}.side));
    verb.add_option("--max-noises", recipe.most_noises,
                    "Refuse what takes more noises: texels times samples times noises of the "
                    "recipe, all frames together")
        ->check(in_range(1.0, 1e30))
        ->default_str(fmt::format("{:.0e}", recipe.most_noises));
    verb.add_option_function<std::string>(
        "--max-memory",
        [](const std::string& text) { limit_memory(memory_size("--max-memory", text)); },
        "Fail (exit code 4) rather than hold more memory, such as 4G; left out: what the system "
        "gives");
}

void copy_input_limits(const MeshOptions& from, const RecipeOptions& recipe_from, MeshOptions& to,
                       RecipeOptions& recipe_to) {
    to.read.named = from.read.named;
    to.read.most_triangles = from.read.most_triangles;
    recipe_to.images->limits = recipe_from.images->limits;
    recipe_to.most_noises = recipe_from.most_noises;
}

void check_noises(const std::string& what, double noises, const RecipeOptions& recipe) {
    if (noises <= recipe.most_noises) return;
    throw Error(
        ExitCode::unsupported,
        fmt::format("{}: {:.2g} noises, some {:.2g} hours of one core, are more than {:.2g} "
                    "(--max-noises); ask for fewer texels, samples or frames, or raise it",
                    what, noises, noises / noises_an_hour, recipe.most_noises));
}

std::uint64_t memory_size(const std::string& option, const std::string& text) {
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, number);
    const std::string unit(stop, end);
    const int shift = unit == "K" ? 10 : unit.empty() || unit == "M" ? 20 : unit == "G" ? 30 : 0;
    if (failure != std::errc() || shift == 0 || !(number > 0.0 && number < 1e9))
        throw Error(ExitCode::usage,
                    fmt::format("{} {}: must be a size such as 512M or 4G", option, text));
    return std::uint64_t(number * double(std::uint64_t(1) << unsigned(shift)));
}

}  // namespace burl
