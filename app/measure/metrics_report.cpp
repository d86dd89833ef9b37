#include "app/measure/metrics_report.h"

#include <cmath>

#include <fmt/format.h>

#include "app/base/messages.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

std::string overscan_name(const MeasuredAtlas& m) {
    return m.name == "uv" ? "-" : std::string(to_string(m.atlas.options.overscan));
}

double texel_share(const MeasuredAtlas& m, std::uint64_t texels) {
    const double size = m.atlas.options.size;
    return double(texels) / (size * size);
}

void print_use(const MeasuredAtlas& m) {
    const AtlasMetrics& use = m.measures.use;
    fmt::print("{:<8} {:<8} {:>6} {:>9.4f} {:>9.4f} {:>9.4f} {:>9.4f} {:>7.3f}/{:.3f}/{:.3f}\n",
               m.name, overscan_name(m), m.atlas.options.size, use.coverage, use.texel_coverage,
               texel_share(m, m.measures.texels.readable), use.relative_scale, use.density[0],
               use.density[1], use.density[2]);
}

void print_shape(const MeasuredAtlas& m) {
    const auto& [use, charts, shape, texels] = m.measures;
    fmt::print("{:<8} {:>8} {:>8.4f} {:>8.3f} {:>8.2f} {:>8.2f} {:>8.4f} {:>8} {:>8} {:>8}\n",
               m.name, charts.with_area, charts.seam_share, charts.vertex_ratio,
               shape.anisotropy_50, shape.anisotropy_95, shape.mirrored, shape.flipped,
               shape.vanished, texels.overlapped);
}

/// The error near seams over that elsewhere; NaN where one of them is missing.
double seam_ratio(const LookupErrors& errors) {
    return errors.interior_rmse > 0.0 && errors.seam_points > 0.0
               ? errors.seam_rmse / errors.interior_rmse
               : std::nan("");
}

/// The error of a level that was evaluated from the recipe; no value for other levels.
std::optional<double> direct_rmse(const MeasuredAtlas& m, std::uint32_t level) {
    if (level == 0 || level > m.direct.size()) return std::nullopt;
    return m.direct[level - 1];
}

void print_views(const std::vector<ViewError>& views) {
    if (views.empty()) return;
    fmt::print("{:<6} {:>5}", "view", "tilt");
    for (const ViewSampler& sampler : view_samplers) fmt::print(" {:>11}", sampler.name);
    fmt::print(" {:>9}\n", "truth +-");
    for (const ViewError& view : views) {
        fmt::print("{:<6} {:>5}", fmt::format("{}:1", view.minification), view.tilt);
        for (const double rmse : view.rmse) fmt::print(" {:>11.5f}", rmse);
        fmt::print(" {:>9.5f}\n", view.truth_noise);
    }
}

void print_lookups(const MeasuredAtlas& m) {
    if (!m.lookups) return;
    const LookupErrors& errors = *m.lookups;
    fmt::print(
        "\n{}: {}{}, {:.2f} dB ({:.2f} dB in 8 bits), seam over interior error {:.2f} "
        "({:.1f} % of points near a seam)\n",
        m.name, printable(m.texture), errors.sharp ? ", sharp levels" : "", errors.psnr,
        errors.psnr_8bit, seam_ratio(errors), 100.0 * errors.seam_points);
    fmt::print("{:<6} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>11}\n", "level", "rmse",
               "direct", "8 bits", "truth +-", "8:1", "8:1 8bit", "mismatch", "foreign",
               "other chart");
    for (const LevelError& e : errors.levels) {
        const std::optional<double> direct = direct_rmse(m, e.level);
        fmt::print(
            "L{:<5} {:>9.5f} {:>9} {:>9.5f} {:>9.5f} {:>9} {:>9} {:>9.5f} {:>9.4f} {:>11.4f}\n",
            e.level, e.rmse, direct ? fmt::format("{:.5f}", *direct) : "-", e.rmse_8bit,
            e.truth_noise, e.grazing ? fmt::format("{:.5f}", e.grazing->rmse) : "-",
            e.grazing ? fmt::format("{:.5f}", e.grazing->rmse_8bit) : "-", e.mismatch, e.foreign,
            e.other_chart);
    }
    print_views(errors.views);
}

Json grazing_json(const LookupErrors& errors) {
    Json levels = Json::array();
    for (const LevelError& e : errors.levels)
        if (e.grazing)
            levels.push_back({{"level", e.level},
                              {"rmse", e.grazing->rmse},
                              {"rmse_8bit", e.grazing->rmse_8bit},
                              {"truth_noise", e.grazing->truth_noise}});
    return levels;
}

Json lookups_json(const MeasuredAtlas& m, const LookupErrors& errors) {
    Json levels = Json::array();
    for (const LevelError& e : errors.levels) {
        const std::optional<double> direct = direct_rmse(m, e.level);
        levels.push_back({{"level", e.level},
                          {"rmse", e.rmse},
                          {"rmse_direct", direct ? Json(*direct) : Json()},
                          {"rmse_8bit", e.rmse_8bit},
                          {"truth_noise", e.truth_noise},
                          {"mismatch", e.mismatch},
                          {"foreign", e.foreign},
                          {"other_chart", e.other_chart}});
    }
    return {{"texture", m.texture},
            {"level_rule", errors.sharp ? "sharp" : "average"},
            {"psnr", errors.psnr},
            {"psnr_8bit", errors.psnr_8bit},
            {"seam_rmse", errors.seam_rmse},
            {"interior_rmse", errors.interior_rmse},
            {"seam_over_interior", seam_ratio(errors)},
            {"seam_points", errors.seam_points},
            {"levels", levels},
            {"grazing_8_to_1", grazing_json(errors)},
            {"sampled_views", views_json(errors.views)}};
}

}  // namespace

Json views_json(const std::vector<ViewError>& views) {
    Json rows = Json::array();
    for (const ViewError& view : views) {
        Json rmse = Json::object();
        for (std::size_t k = 0; k < view_samplers.size(); ++k)
            rmse[std::string(view_samplers[k].name)] = view.rmse[k];
        rows.push_back({{"minification", view.minification},
                        {"tilt", view.tilt},
                        {"rmse", rmse},
                        {"truth_noise", view.truth_noise}});
    }
    return rows;
}

Json measured_json(const MeasuredAtlas& m) {
    const auto& [use, charts, shape, texels] = m.measures;
    Json json = metrics_json(m.atlas, use);
    json["kind"] = m.name;
    if (m.name == "uv") json["overscan"] = nullptr;
    json["charts"] = charts.with_area;
    json["readable_texels"] = texel_share(m, texels.readable);
    json["covered_texels"] = texel_share(m, texels.covered);
    json["overlapped_texels"] = texels.overlapped;
    json["outside_triangles"] = texels.outside;
    json["seam_length"] = charts.seam_length;
    json["seam_share"] = charts.seam_share;
    json["vertices"] = charts.vertices;
    json["vertex_ratio"] = charts.vertex_ratio;
    json["anisotropy_50_95"] = {shape.anisotropy_50, shape.anisotropy_95};
    json["mirrored_area"] = shape.mirrored;
    json["flipped"] = shape.flipped;
    json["vanished"] = shape.vanished;
    json["images"] = m.images;
    if (m.lookups) json["lookups"] = lookups_json(m, *m.lookups);
    return json;
}

void print_measures(const std::vector<MeasuredAtlas>& atlases) {
    fmt::print("{:<8} {:<8} {:>6} {:>9} {:>9} {:>9} {:>9} {:>19}\n", "atlas", "overscan", "size",
               "coverage", "owned", "readable", "scale", "density 5/50/95 %");
    for (const MeasuredAtlas& m : atlases) print_use(m);
    fmt::print("\n{:<8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "atlas", "charts",
               "seams", "vertices", "aniso50", "aniso95", "mirrored", "flipped", "vanished",
               "overlap");
    for (const MeasuredAtlas& m : atlases) {
        print_shape(m);
        if (m.measures.texels.outside != 0)
            fmt::print("  {} triangles leave the texture: lookups are clamped to its edge\n",
                       m.measures.texels.outside);
    }
    for (const MeasuredAtlas& m : atlases) print_lookups(m);
}

}  // namespace burl
