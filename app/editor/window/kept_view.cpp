#include "app/editor/window/kept_view.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/base/json_text.h"
#include "atlas/base/json.h"
#include "atlas/base/real_path.h"

namespace burl {

namespace {

constexpr double farthest = 1e3;  // of distance and target, in radii

/// Reads the numbers of a camera; false where one is missing or beyond its limits.
bool read_camera(const Json& json, EditCamera& camera) {
    if (!json.is_array() || json.size() != 6) return false;
    for (const Json& number : json)
        if (!number.is_number() || !(std::abs(number.get<double>()) <= farthest)) return false;
    const auto at = [&](std::size_t i) { return json[i].get<double>(); };
    camera.view = {at(0), std::clamp(at(1), -90.0, 90.0), std::clamp(at(2), 0.05, 100.0)};
    camera.target = {at(3), at(4), at(5)};
    return true;
}

std::string text_at(const Json& json, const char* key) {
    const bool has = json.contains(key) && json[key].is_string();
    return has ? json[key].get<std::string>() : std::string();
}

}  // namespace

std::string to_text(UpAxis up) {
    return up == UpAxis::y ? "y" : up == UpAxis::z ? "z" : "-z";
}

UpAxis up_axis_from(const std::string& text) {
    return text == "z" ? UpAxis::z : text == "-z" ? UpAxis::minus_z : UpAxis::y;
}

std::string kept_name(const std::string& mesh) {
    std::error_code unknown;
    return std::filesystem::is_regular_file(mesh, unknown) ? real_path(mesh) : mesh;
}

std::string view_text(const EditOpenFiles& files, const EditCamera& camera) {
    if (files.mesh().empty()) return {};
    const View& view = camera.view;
    Json json{{"mesh", kept_name(files.mesh())},
              {"camera",
               {view.azimuth_degrees, view.elevation_degrees, view.distance, camera.target.x,
                camera.target.y, camera.target.z}},
              {"up", to_text(camera.up)}};
    if (!files.pose().empty()) json["pose"] = kept_name(files.pose());
    return print_json(json);
}

std::optional<KeptView> kept_view_from(const std::string& text) {
    const Json json = parse_json_value(text);
    KeptView kept;
    if (!json.is_object() || !json.contains("camera") || !read_camera(json["camera"], kept.camera))
        return {};
    kept.mesh = text_at(json, "mesh");
    kept.pose = text_at(json, "pose");
    kept.camera.up = up_axis_from(text_at(json, "up"));
    if (kept.mesh.empty()) return {};
    return kept;
}

}  // namespace burl
