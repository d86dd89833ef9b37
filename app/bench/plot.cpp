#include "app/bench/plot.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bench/plot_curves.h"
#include "app/bench/plot_parts.h"
#include "app/bench/plot_shares.h"
#include "app/bench/svg_text.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

constexpr double strip = 28;  ///< for what has no error, and for what has none known

struct Point {
    std::size_t method = 0;
    double ns = 0.0, lowest = 0.0, highest = 0.0;
    std::optional<double> error;
    double x = 0.0, y = 0.0, x_lowest = 0.0, x_highest = 0.0;  ///< in its panel
    bool best = false;                                         ///< on the Pareto front
};

struct Panel {
    std::string title;
    std::vector<Point> points;
};

struct Plot {
    std::vector<Panel> panels;
    std::vector<std::string> methods;
    std::string unit;
};

void add_row(const Json& row, const char* error_key, Plot& plot) {
    const auto ns = number_at(row, "ns_median");
    const std::string method = text_at(row, "method");
    if (!ns || !(*ns > 0.0) || method.empty()) return;
    const std::string group = text_at(row, "group");
    auto panel = std::ranges::find(plot.panels, group, &Panel::title);
    if (panel == plot.panels.end()) panel = plot.panels.insert(panel, Panel{group, {}});
    const auto error = number_at(row, error_key);
    const auto bound = [&](const char* key) {
        const double bound_ns = number_at(row, key).value_or(*ns);
        return bound_ns > 0.0 ? bound_ns : *ns;
    };
    panel->points.push_back({index_in(plot.methods, method), *ns, bound("ns_lowest"),
                             bound("ns_highest"), error && *error >= 0.0 ? error : std::nullopt});
    plot.unit = text_at(row, "unit");
}

/// Whether any row has a number above 0 there.
bool has(const Json& rows, const char* key) {
    return std::any_of(rows.begin(), rows.end(), [&](const Json& row) {
        return row.is_object() && number_at(row, key).value_or(0.0) > 0.0;
    });
}

/// Marks what nothing else beats in both time and error.
void mark_front(Panel& panel) {
    for (Point& p : panel.points)
        p.best = p.error && std::ranges::none_of(panel.points, [&](const Point& q) {
                     return q.error && ((q.ns <= p.ns && *q.error < *p.error) ||
                                        (q.ns < p.ns && *q.error <= *p.error));
                 });
}

void place_points(const PlotAxes& axes, Panel& panel) {
    for (Point& p : panel.points) {
        p.x = axes.x_of(p.ns);
        p.x_lowest = axes.x_of(p.lowest);
        p.x_highest = axes.x_of(p.highest);
        p.y = strip / 2;
        if (p.error && *p.error > 0.0)
            p.y = axes.y_of(*p.error);
        else if (p.error)
            p.y = plot_height - strip / 2;
    }
}

std::string front_line(const Panel& panel) {
    std::vector<const Point*> front;
    for (const Point& p : panel.points)
        if (p.best) front.push_back(&p);
    std::ranges::sort(front, {}, [](const Point* p) { return p->ns; });
    std::string path;
    for (const Point* p : front)
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", p->x, p->y);
    return fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"#444444\" stroke-dasharray=\"5 3\"/>\n", path);
}

/// Numbers beside the markers, each at the first free place round its own.
std::string numbers(const Panel& panel) {
    SvgLabels labels({0, 0, plot_width, plot_height});
    for (const Point& p : panel.points) {
        labels.keep_free({p.x - 5, p.y - 5, p.x + 5, p.y + 5});
        labels.keep_free({p.x_lowest, p.y - 1, p.x_highest, p.y + 1});
    }
    std::string svg;
    for (const Point& p : panel.points) svg += labels.place(p.x, p.y, std::to_string(p.method + 1));
    return svg;
}

std::string panel_svg(Panel& panel, const PlotAxes& axes) {
    place_points(axes, panel);
    std::string svg = plot_grid(axes, panel.title);
    const bool exact = std::ranges::any_of(
        panel.points, [](const Point& p) { return p.error && *p.error == 0.0; });
    if (exact) svg += svg_text(-5, plot_height - strip / 2 + 4, "end", "0");
    if (std::ranges::any_of(panel.points, [](const Point& p) { return !p.error; }))
        svg += svg_text(-5, strip / 2 + 4, "end", "?");
    svg += front_line(panel);
    for (const Point& p : panel.points)
        svg += svg_line(p.x_lowest, p.y, p.x_highest, p.y, plot_color(p.method));
    for (const Point& p : panel.points) svg += plot_marker(p.method, p.x, p.y, p.best);
    return svg + numbers(panel);
}

Plot read_plot(const Json& report, const std::string& origin, const char*& error_key) {
    const Json& rows = report["rows"];
    error_key = has(rows, "error_rms") ? "error_rms" : "error_max";
    Plot plot;
    for (const Json& row : rows)
        if (row.is_object()) add_row(row, error_key, plot);
    if (plot.panels.empty() || !has(rows, error_key))
        throw invalid_file(origin, 0,
                           "its rows set no times (ns_median) against errors (error_rms): use the "
                           "report of any suite but mesh_io");
    return plot;
}

PlotAxes axes_over(const Plot& plot, bool rms) {
    std::vector<double> times, errors;
    for (const Panel& panel : plot.panels)
        for (const Point& p : panel.points) {
            times.insert(times.end(), {p.lowest, p.highest});
            if (p.error && *p.error > 0.0) errors.push_back(*p.error);
        }
    return {DecadeAxis::over(times), DecadeAxis::over(errors),
            "run time, ns per " + (plot.unit.empty() ? std::string("unit") : plot.unit),
            rms ? "RMS error (peak 1)" : "largest error (peak 1)", strip};
}

/// Run time against error.
std::string error_plot(const Json& report, const std::string& origin) {
    const char* error_key = nullptr;
    Plot plot = read_plot(report, origin, error_key);
    const PlotAxes axes = axes_over(plot, std::string_view(error_key) == "error_rms");
    PlotPage page{{}, plot.methods, true};
    for (Panel& panel : plot.panels) {
        mark_front(panel);
        page.panels.push_back(panel_svg(panel, axes));
    }
    return plot_document(report,
                         "Dashed, black rims: Pareto front. Bars: fastest to slowest round.", page);
}

}  // namespace

std::string bench_plot(const Json& report, const std::string& origin) {
    if (!report.is_object() || !report.contains("rows") || !report["rows"].is_array())
        throw invalid_file(origin, 0, "this is no report of burl bench: it has no rows");
    const Json& rows = report["rows"];
    if (has_curves(rows)) return curve_plot(report, rows);
    if (has_shares(rows)) return share_plot(report, rows);
    return error_plot(report, origin);
}

}  // namespace burl
