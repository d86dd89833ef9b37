// Everything is placed by arithmetic on the widths that text has at most, so that nothing overlaps
// in any viewer's fonts.
#include "app/bench_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "app/svg_text.h"
#include "atlas/error.h"

namespace burl {

namespace {

constexpr double panel_width = 300, panel_height = 230, strip = 28;
constexpr double margin_left = 52, margin_bottom = 40, margin_top = 26, gap = 14;
constexpr double title_height = 48, legend_row = 17;

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

/// Decades from the first to the last.
struct Axis {
    int low = 0, high = 1;
    double place(double value, double length) const {
        return (std::log10(value) - low) / (high - low) * length;
    }
    static Axis over(const std::vector<double>& values) {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        const int low = int(std::floor(std::log10(*least) - 0.02));
        return {low, std::max(low + 1, int(std::ceil(std::log10(*most) + 0.02)))};
    }
};

template <class T>
std::size_t index_in(std::vector<T>& all, const T& one) {
    const auto found = std::ranges::find(all, one);
    if (found != all.end()) return std::size_t(found - all.begin());
    all.push_back(one);
    return all.size() - 1;
}

std::optional<double> number_at(const Json& row, const char* key) {
    if (!row.contains(key) || !row[key].is_number()) return {};
    return row[key].get<double>();
}

std::string text_at(const Json& row, const char* key) {
    return row.contains(key) && row[key].is_string() ? row[key].get<std::string>() : std::string();
}

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

constexpr std::array colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                            "#E69F00", "#56B4E9", "#000000"};

/// Method's colour and shape at (x, y); the shape changes when the colours have run out, too.
std::string marker(std::size_t method, double x, double y, bool best) {
    constexpr double r = 4.5;
    const std::string style =
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"", colors[method % colors.size()],
                    best ? "#000000" : "#ffffff", best ? 1.4 : 0.7);
    switch (method % 4) {
        case 0:
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>\n", x, y, r,
                               style);
        case 1:
            return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" {}/>\n",
                               x - 4, y - 4, 8, 8, style);
        case 2:
            return fmt::format("<path d=\"M{:.1f} {:.1f}l5 9h-10z\" {}/>\n", x, y - 5.5, style);
        default:
            return fmt::format("<path d=\"M{:.1f} {:.1f}l5.5 5.5l-5.5 5.5l-5.5 -5.5z\" {}/>\n", x,
                               y - 5.5, style);
    }
}

struct Axes {
    Axis time, error;
    std::string time_title, error_title;
};

/// Where a decade's line has its label: every one, or so many apart that they have room.
int label_step(const Axis& axis) {
    return (axis.high - axis.low + 5) / 6;
}

std::string grid(const Axes& axes) {
    std::string svg =
        fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#666666\"/>\n",
                    panel_width, panel_height);
    for (int e = axes.time.low; e <= axes.time.high; ++e) {
        const double x = axes.time.place(std::pow(10.0, e), panel_width);
        svg += svg_line(x, 0, x, panel_height, "#dddddd");
        if ((e - axes.time.low) % label_step(axes.time) == 0)
            svg += svg_text(x, panel_height + 14, "middle", decade_text(e));
    }
    for (int e = axes.error.low; e <= axes.error.high; ++e) {
        const double y =
            panel_height - strip - axes.error.place(std::pow(10.0, e), panel_height - 2 * strip);
        svg += svg_line(0, y, panel_width, y, "#dddddd");
        if ((e - axes.error.low) % label_step(axes.error) == 0)
            svg += svg_text(-5, y + 4, "end", decade_text(e));
    }
    svg += svg_text(panel_width / 2, panel_height + 32, "middle", axes.time_title);
    return svg + fmt::format(
                     "<text transform=\"translate({} {}) rotate(-90)\" "
                     "text-anchor=\"middle\">{}</text>\n",
                     -margin_left + 12, panel_height / 2, svg_escaped(axes.error_title));
}

void place_points(const Axes& axes, Panel& panel) {
    for (Point& p : panel.points) {
        p.x = axes.time.place(p.ns, panel_width);
        p.x_lowest = axes.time.place(p.lowest, panel_width);
        p.x_highest = axes.time.place(p.highest, panel_width);
        p.y = strip / 2;
        if (p.error && *p.error > 0.0)
            p.y = panel_height - strip - axes.error.place(*p.error, panel_height - 2 * strip);
        else if (p.error)
            p.y = panel_height - strip / 2;
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
    SvgLabels labels({0, 0, panel_width, panel_height});
    for (const Point& p : panel.points) {
        labels.keep_free({p.x - 5, p.y - 5, p.x + 5, p.y + 5});
        labels.keep_free({p.x_lowest, p.y - 1, p.x_highest, p.y + 1});
    }
    std::string svg;
    for (const Point& p : panel.points) svg += labels.place(p.x, p.y, std::to_string(p.method + 1));
    return svg;
}

std::string panel_svg(Panel& panel, const Axes& axes) {
    place_points(axes, panel);
    std::string svg = grid(axes) + svg_text(0, -8, "start", panel.title, "font-weight=\"bold\"");
    const bool exact = std::ranges::any_of(
        panel.points, [](const Point& p) { return p.error && *p.error == 0.0; });
    if (exact) svg += svg_text(-5, panel_height - strip / 2 + 4, "end", "0");
    if (std::ranges::any_of(panel.points, [](const Point& p) { return !p.error; }))
        svg += svg_text(-5, strip / 2 + 4, "end", "?");
    svg += front_line(panel);
    for (const Point& p : panel.points)
        svg += svg_line(p.x_lowest, p.y, p.x_highest, p.y, colors[p.method % colors.size()]);
    for (const Point& p : panel.points) svg += marker(p.method, p.x, p.y, p.best);
    return svg + numbers(panel);
}

Plot read_plot(const Json& report, const std::string& origin, const char*& error_key) {
    if (!report.is_object() || !report.contains("rows") || !report["rows"].is_array())
        throw invalid_file(origin, 0, "this is no report of burl bench: it has no rows");
    const Json& rows = report["rows"];
    error_key = has(rows, "error_rms") ? "error_rms" : "error_max";
    Plot plot;
    for (const Json& row : rows)
        if (row.is_object()) add_row(row, error_key, plot);
    if (plot.panels.empty() || !has(rows, error_key))
        throw invalid_file(origin, 0,
                           "its rows do not set times (ns_median) against errors (error_rms): use "
                           "the report of bench noise, synthesis, filter or atlas");
    return plot;
}

Axes axes_over(const Plot& plot, bool rms) {
    std::vector<double> times, errors;
    for (const Panel& panel : plot.panels)
        for (const Point& p : panel.points) {
            times.insert(times.end(), {p.lowest, p.highest});
            if (p.error && *p.error > 0.0) errors.push_back(*p.error);
        }
    return {Axis::over(times), Axis::over(errors),
            "run time, ns per " + (plot.unit.empty() ? std::string("unit") : plot.unit),
            rms ? "RMS error (peak 1)" : "largest error (peak 1)"};
}

/// The methods' numbers, markers and names in columns below the panels.
std::string legend(const Plot& plot, double width, double& height) {
    std::size_t longest = 0;
    for (const std::string& method : plot.methods) longest = std::max(longest, method.size());
    const double column = 46 + svg_width(longest);
    const auto columns = std::size_t(std::max(1.0, std::floor(width / column)));
    const std::size_t per_column = (plot.methods.size() + columns - 1) / columns;
    std::string svg;
    for (std::size_t m = 0; m < plot.methods.size(); ++m) {
        const double x = double(m / per_column) * column, y = double(m % per_column) * legend_row;
        svg += svg_text(x + 16, y + 4, "end", std::to_string(m + 1)) + marker(m, x + 26, y, false) +
               svg_text(x + 36, y + 4, "start", plot.methods[m]);
    }
    height = double(per_column) * legend_row;
    return svg;
}

std::string heading(const Json& report) {
    std::string machine;
    if (report.contains("machine") && report["machine"].is_object())
        machine = fmt::format("{}, {}", text_at(report["machine"], "cpu"),
                              text_at(report["machine"], "simd"));
    return svg_text(0, 16, "start", "burl bench " + text_at(report, "suite"),
                    "font-size=\"15\" font-weight=\"bold\"") +
           svg_text(0, 34, "start",
                    machine + (machine.empty() ? "" : ". ") +
                        "Dashed, black rims: Pareto front. Bars: fastest to slowest round.");
}

}  // namespace

std::string bench_plot(const Json& report, const std::string& origin) {
    const char* error_key = nullptr;
    Plot plot = read_plot(report, origin, error_key);
    const Axes axes = axes_over(plot, std::string_view(error_key) == "error_rms");
    const auto count = plot.panels.size();
    const std::size_t columns = count > 8 ? 4 : std::clamp<std::size_t>(count, 2, 3);
    const double cell_width = margin_left + panel_width + gap,
                 cell_height = margin_top + panel_height + margin_bottom + gap;
    const double width = double(columns) * cell_width;
    std::string body = fmt::format("<g transform=\"translate(16 8)\">\n{}</g>\n", heading(report));
    for (std::size_t i = 0; i < count; ++i) {
        mark_front(plot.panels[i]);
        body += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n",
                            16 + double(i % columns) * cell_width + margin_left,
                            title_height + double(i / columns) * cell_height + margin_top,
                            panel_svg(plot.panels[i], axes));
    }
    const double rows = double((count + columns - 1) / columns);
    double legend_height = 0.0;
    const std::string names = legend(plot, width, legend_height);
    const double top = title_height + rows * cell_height + 12;
    body += fmt::format("<g transform=\"translate(16 {:.0f})\">\n{}</g>\n", top, names);
    return svg_document(width + 32, top + legend_height + 12, body);
}

}  // namespace burl
