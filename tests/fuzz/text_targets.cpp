// Manifests, scripts of the editor, points, and records of bakes.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/bake/batch_manifest.h"
#include "app/bake/up_to_date.h"
#include "app/base/json_text.h"
#include "app/base/sha256.h"
#include "app/editor/session/script.h"
#include "app/measure/evaluate_points.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/json.h"
#include "tests/fuzz/target.h"

namespace burl::fuzz {
namespace {

void read_words(const std::vector<std::string>& words) {
    for (const std::string& word : words)
        attempt([&] {
            const BatchShard shard = batch_shard(word);
            require(shard.first(1000) <= shard.last(1000) && shard.last(1000) <= 1000,
                    "shards are parts of what there is");
        });
    for (const BatchEntry& entry : matrix_of_options({"sample:cube"}, words, {1, 3}))
        require(!entry.where.empty(), "entries have places");
}

/// A manifest; or a list of words, each of which is an option of a command line or a shard.
void read_manifest_file(const std::string& bytes) {
    const Json json = parse_json_value(bytes);
    if (json.is_array() && std::ranges::all_of(json, [](auto& one) { return one.is_string(); }))
        return read_words(json);
    const std::string path = scratch_file("a.json", bytes);
    const auto read = [&](const BatchShard& shard) {
        const std::vector<BatchEntry> entries = read_manifest(path, shard);
        for (const BatchEntry& entry : entries)
            require(!entry.where.empty(), "entries have places");
        return entries.size();
    };
    // A bake takes milliseconds with sanitizers, so that all are read where they are not too many.
    if (read({0, 100}) < 20) read({});
}

void read_script(const std::string& bytes) {
    const InputScript script = parse_script(bytes, "a.json");
    const std::string text = script_text(script);
    require(script_text(parse_script(text, "a.json")) == text,
            "a script that is written and read is the same");
    ScriptPlayer player(script);
    const auto find = [](const std::string&) { return ItemRect{{0, 0}, {10, 10}}; };
    InputScript recorded;
    for (int frame = 0; frame < 1000 && !player.done(); ++frame)
        append_frame(recorded, player.next(find).events);
    parse_script(script_text(recorded), "recorded.json");
}

void evaluate_noise(const PointFile& file, PrecisionKind precision,
                    std::vector<std::string> arguments) {
    CLI::App verb;
    NoiseOptions noise;
    noise.add(verb);
    verb.parse(std::move(arguments));
    for (const PointResult& result : evaluate_points(noise, file, {precision, {}}))
        require(std::isfinite(result.float64.value) &&
                    result.other.has_value() == (precision != PrecisionKind::float64),
                "noise is finite, and in a second precision where one is asked for");
}

void evaluate_recipe(const PointFile& file, const std::string& preset,
                     const std::string& precision) {
    const Recipe recipe = load_recipe(preset, {"precision.kind=" + precision});
    for (const PointResult& result : evaluate_points(recipe, file))
        require(std::isfinite(result.float64.value), "values of recipes are finite");
}

/// The points, and noises and recipes of all precisions at the first of them.
void read_points_file(const std::string& bytes) {
    PointFile file = read_points(scratch_file("a.csv", bytes));
    require(file.dimensions >= 1 && file.dimensions <= 4, "points have one to four coordinates");
    if (file.points.size() > 32) file.points.resize(32);
    for (const auto kind : {PrecisionKind::float64, PrecisionKind::float32, PrecisionKind::fixed})
        for (const auto* sum : {"--sum=fbm", "--sum=ridged"})
            attempt([&] { evaluate_noise(file, kind, {"--octaves=3", sum, "--noise=perlin"}); });
    attempt([&] {
        evaluate_noise(file, PrecisionKind::float32, {"--warp=0.5", "--noise=worley"});
    });
    for (const auto* preset : {"marble", "oak"})
        for (const auto* precision : {"float64", "float32", "fixed"})
            attempt([&] { evaluate_recipe(file, preset, precision); });
}

/// The record with its digest, as app/bake/up_to_date.cpp writes it.
std::string with_digest(const Json& record) {
    std::string text = print_json(record);
    text.resize(text.size() - std::min<std::size_t>(text.size(), 3));
    return fmt::format("{}{}{}{}", text, ",\n  \"sha256\": \"", sha256(text), "\"\n}\n");
}

/// Writes the record that a bake would have written, and asks for it.
void write_again(const std::string& output, const Json& made_from) {
    FileDigests digests;
    const std::string none = output + ".none";
    const Json report = {{"content", content_of(std::array{output, none}, digests)}};
    const CommittedFile file = *file_there(output);
    write_record(output, made_from, {&file, 1}, report);
    require(report_if_up_to_date(output, made_from) == report,
            "what was just written is up to date");
}

/// A record whose digest is right; the outputs that it names are looked for.
void read_record(const std::string& bytes) {
    const Json json = parse_json_value(bytes);
    if (json.is_discarded()) return;
    const Json made_from = json.is_object() ? json.value("made_from", Json()) : Json();
    const std::string output = scratch_file("a.png", "");
    scratch_file("a.png.burl.json", with_digest(json));
    report_if_up_to_date(output, made_from);
    write_again(output, made_from);
}

}  // namespace

std::vector<Target> text_targets() {
    return {
        {"manifest",
         read_manifest_file,
         Form::json,
         {"tests/cases"},
         {"mesh",      "recipe",      "output",
          "set",       "size",        "defaults",
          "bakes",     "sample:cube", "{mesh}-{recipe}.png",
          "levels",    "animate",     "camera.azimuth=0:360",
          "threads",   "emit-glsl",   "solid-map",
          "only-mesh", "assign",      "*=marble",
          "*.obj",     "time"}},
        {"script",
         read_script,
         Form::json,
         {},
         {"burl_input", "size", "steps", "click", "double_click", "drag", "by", "to", "wheel",
          "key", "Ctrl+Z", "type", "drop", "resize", "wait", "settle", "screenshot", "events",
          "frames"}},
        {"points",
         read_points_file,
         Form::text,
         {},
         {"x", "y", "z", "w", ",", "#", "\r\n", "\xef\xbb\xbf", "nan", "inf", "1e999", "+1",
          "0x1"}},
        {"record",
         read_record,
         Form::json,
         {},
         {"made_from", "outputs", "report", "file", "state", "size", "time", "inode", "a.png"}}};
}

}  // namespace burl::fuzz
