#include "app/recipe/paint_json.h"

#include <nlohmann/json.hpp>

#include "procedural/model/texture_json.h"

namespace burl {

namespace {

PaintStroke stroke_from_json(const Json& json) {
    PaintStroke stroke;
    if (json.value("mode", "paint") == "erase") stroke.mode = PaintMode::erase;
    if (json.contains("color")) stroke.color = color_from_hex(json["color"].get<std::string>());
    stroke.radius = json.value("radius", stroke.radius);
    stroke.hardness = json.value("hardness", stroke.hardness);
    stroke.opacity = json.value("opacity", stroke.opacity);
    if (json.contains("points"))
        for (const Json& p : json["points"])
            stroke.points.emplace_back(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
    return stroke;
}

Json stroke_to_json(const PaintStroke& stroke) {
    Json points = Json::array();
    for (const Vec3d& p : stroke.points) points.push_back({p.x, p.y, p.z});
    return {{"mode", stroke.mode == PaintMode::erase ? "erase" : "paint"},
            {"color", color_to_hex(stroke.color)},
            {"radius", stroke.radius},
            {"hardness", stroke.hardness},
            {"opacity", stroke.opacity},
            {"points", std::move(points)}};
}

}  // namespace

std::vector<PaintStroke> paint_from_json(const Json& json) {
    std::vector<PaintStroke> strokes;
    for (const Json& stroke : json) strokes.push_back(stroke_from_json(stroke));
    return strokes;
}

Json paint_to_json(const std::vector<PaintStroke>& strokes) {
    Json json = Json::array();
    for (const PaintStroke& stroke : strokes) json.push_back(stroke_to_json(stroke));
    return json;
}

}  // namespace burl
