// Manifests, scripts of the editor, points, and records of bakes.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bake/batch_manifest.h"
#include "app/bake/up_to_date.h"
#include "app/base/json_text.h"
#include "app/base/sha256.h"
#include "app/editor/session/script.h"
#include "app/measure/evaluate_points.h"
#include "tests/fuzz/target.h"

namespace burl::fuzz {
namespace {

void read_manifest_file(const std::string& bytes) {
    for (const BatchEntry& entry : read_manifest(scratch_file("a.json", bytes)))
        require(!entry.where.empty(), "entries have places");
}

void read_script(const std::string& bytes) {
    const InputScript script = parse_script(bytes, "a.json");
    const std::string text = script_text(script);
    require(script_text(parse_script(text, "a.json")) == text,
            "a script that is written and read is the same");
    ScriptPlayer player(script);
    const auto find = [](const std::string&) { return ItemRect{{0, 0}, {10, 10}}; };
    for (int frame = 0; frame < 1000 && !player.done(); ++frame) player.next(find);
}

void read_points_file(const std::string& bytes) {
    const PointFile file = read_points(scratch_file("a.csv", bytes));
    require(file.dimensions >= 1 && file.dimensions <= 4, "points have one to four coordinates");
}

/// The record with its digest, as app/bake/up_to_date.cpp writes it.
std::string with_digest(const Json& record) {
    std::string text = print_json(record);
    text.resize(text.size() - std::min<std::size_t>(text.size(), 3));
    return fmt::format("{}{}{}{}", text, ",\n  \"sha256\": \"", sha256(text), "\"\n}\n");
}

/// A record whose digest is right; the outputs that it names are looked for.
void read_record(const std::string& bytes) {
    const Json json = parse_json_value(bytes);
    if (json.is_discarded()) return;
    const Json made_from = json.is_object() ? json.value("made_from", Json()) : Json();
    const std::string output = scratch_file("a.png", "");
    scratch_file("a.png.burl.json", with_digest(json));
    report_if_up_to_date(output, made_from);
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
