#include "app/bench/plot_curves.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bench/plot_parts.h"
#include "app/bench/svg_text.h"

namespace burl {

namespace {

struct CurvePoint {
    double x = 0.0, y = 0.0;
};

struct Curve {
    std::size_t method = 0;
    std::vector<CurvePoint> points;
};

struct CurvePanel {
    std::string title;
    std::string quantity;  ///< title of y
    std::vector<Curve> curves;
};

struct Curves {
    std::vector<CurvePanel> panels;
    std::vector<std::string> methods;

    void add(const std::string& title, const std::string& quantity, const std::string& method,
             std::optional<double> x, std::optional<double> y) {
        if (!x || !y || !(*x > 0.0) || !(*y > 0.0)) return;
        const auto same = [&](const CurvePanel& p) {
            return p.title == title && p.quantity == quantity;
        };
        auto panel = std::ranges::find_if(panels, same);
        if (panel == panels.end()) panel = panels.insert(panel, {title, quantity, {}});
        const std::size_t m = index_in(methods, method);
        auto curve = std::ranges::find(panel->curves, m, &Curve::method);
        if (curve == panel->curves.end()) curve = panel->curves.insert(curve, {m, {}});
        curve->points.push_back({*x, *y});
    }
};

/// Rows of `forward`: a method's time and error at a step.
void add_forward(const Json& row, Curves& curves) {
    const auto step = number_at(row, "step_cells");
    const std::string title = text_at(row, "function"), method = text_at(row, "method");
    if (!step || title.empty() || method.empty()) return;
    curves.add(title, "ns per texel", method, step, number_at(row, "ns_per_texel"));
    curves.add(title, "largest error", method, step, number_at(row, "error"));
}

/// Rows of `kernels`: every key that begins with ns_ is a way.
void add_kernels(const Json& row, Curves& curves) {
    const std::string title = text_at(row, "noise");
    if (title.empty()) return;
    for (const auto& [key, value] : row.items())
        if (key.starts_with("ns_"))
            curves.add(title, "ns per texel", key.substr(3), number_at(row, "crossings_per_texel"),
                       number_at(row, key.c_str()));
}

std::string curve_svg(const Curve& curve, const PlotAxes& axes) {
    std::string path, markers;
    for (const auto& [x, y] : curve.points) {
        path +=
            fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", axes.x_of(x), axes.y_of(y));
        markers += plot_marker(curve.method, axes.x_of(x), axes.y_of(y), false);
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"/>\n{}",
                       path, plot_color(curve.method), markers);
}

/// Over all panels that show the quantity.
PlotAxes axes_of(const Curves& curves, const std::string& quantity, const std::string& x_title) {
    std::vector<double> x, y;
    for (const CurvePanel& panel : curves.panels)
        for (const Curve& curve : panel.curves)
            for (const CurvePoint& point : curve.points) {
                x.push_back(point.x);
                if (panel.quantity == quantity) y.push_back(point.y);
            }
    return {DecadeAxis::over(x), DecadeAxis::over(y), x_title, quantity};
}

Curves read_curves(const Json& rows) {
    Curves curves;
    for (const Json& row : rows) {
        if (!row.is_object()) continue;
        add_forward(row, curves);
        add_kernels(row, curves);
    }
    for (CurvePanel& panel : curves.panels)
        for (Curve& curve : panel.curves) std::ranges::sort(curve.points, {}, &CurvePoint::x);
    return curves;
}

}  // namespace

bool has_curves(const Json& rows) {
    return !read_curves(rows).panels.empty();
}

std::string curve_plot(const Json& report, const Json& rows) {
    const Curves curves = read_curves(rows);
    const bool steps = std::any_of(rows.begin(), rows.end(),
                                   [](const Json& row) { return row.contains("step_cells"); });
    const std::string x_title = steps ? "cells per texel" : "lattice planes a texel crosses";
    PlotPage page{{}, curves.methods, false};
    for (const CurvePanel& panel : curves.panels) {
        const PlotAxes axes = axes_of(curves, panel.quantity, x_title);
        std::string svg = plot_grid(axes, panel.title);
        for (const Curve& curve : panel.curves) svg += curve_svg(curve, axes);
        page.panels.push_back(svg);
    }
    return plot_document(report, "Medians of paired runs.", page);
}

}  // namespace burl
