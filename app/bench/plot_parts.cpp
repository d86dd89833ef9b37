#include "app/bench/plot_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bench/svg_text.h"

namespace burl {

namespace {

constexpr double margin_left = 52, margin_bottom = 40, margin_top = 26, gap = 14;
constexpr double title_height = 48, legend_row = 17;

constexpr std::array line_colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                 "#E69F00", "#56B4E9", "#000000"};

/// Where a decade's line has its label: every one, or so many apart that they have room.
int label_step(const DecadeAxis& axis) {
    return (axis.high - axis.low + 5) / 6;
}

/// The methods' numbers, markers and names in columns below the panels.
std::string legend(const PlotPage& page, double width, double& height) {
    std::size_t longest = 0;
    for (const std::string& method : page.methods) longest = std::max(longest, method.size());
    const double column = 46 + svg_width(longest);
    const auto columns = std::size_t(std::max(1.0, std::floor(width / column)));
    const std::size_t per_column = (page.methods.size() + columns - 1) / columns;
    std::string svg;
    for (std::size_t m = 0; m < page.methods.size(); ++m) {
        const double x = double(m / per_column) * column, y = double(m % per_column) * legend_row;
        if (page.numbered) svg += svg_text(x + 16, y + 4, "end", std::to_string(m + 1));
        svg += plot_marker(m, x + 26, y, false) + svg_text(x + 36, y + 4, "start", page.methods[m]);
    }
    height = double(per_column) * legend_row;
    return svg;
}

std::string heading(const Json& report, const std::string& note) {
    std::string machine;
    if (report.contains("machine") && report["machine"].is_object())
        machine = fmt::format("{}, {}. ", text_at(report["machine"], "cpu"),
                              text_at(report["machine"], "simd"));
    return svg_text(0, 16, "start", "burl bench " + text_at(report, "suite"),
                    "font-size=\"15\" font-weight=\"bold\"") +
           svg_text(0, 34, "start", machine + note);
}

}  // namespace

double DecadeAxis::place(double value, double length) const {
    return (std::log10(value) - low) / (high - low) * length;
}

DecadeAxis DecadeAxis::over(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const int low = int(std::floor(std::log10(*least) - 0.02));
    return {low, std::max(low + 1, int(std::ceil(std::log10(*most) + 0.02)))};
}

std::string plot_grid(const PlotAxes& axes, const std::string& title) {
    std::string svg =
        fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#666666\"/>\n",
                    plot_width, plot_height);
    for (int e = axes.x.low; e <= axes.x.high; ++e) {
        const double x = axes.x_of(std::pow(10.0, e));
        svg += svg_line(x, 0, x, plot_height, "#dddddd");
        if ((e - axes.x.low) % label_step(axes.x) == 0)
            svg += svg_text(x, plot_height + 14, "middle", decade_text(e));
    }
    for (int e = axes.y.low; e <= axes.y.high; ++e) {
        const double y = axes.y_of(std::pow(10.0, e));
        svg += svg_line(0, y, plot_width, y, "#dddddd");
        if ((e - axes.y.low) % label_step(axes.y) == 0)
            svg += svg_text(-5, y + 4, "end", decade_text(e));
    }
    svg += svg_text(plot_width / 2, plot_height + 32, "middle", axes.x_title);
    svg += fmt::format(
        "<text transform=\"translate({} {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
        -margin_left + 12, plot_height / 2, svg_escaped(axes.y_title));
    return svg + svg_text(0, -8, "start", title, "font-weight=\"bold\"");
}

std::string plot_color(std::size_t method) {
    return line_colors[method % line_colors.size()];
}

std::string plot_marker(std::size_t method, double x, double y, bool best) {
    constexpr double r = 4.5;
    const std::string style =
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"", plot_color(method),
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

std::optional<double> number_at(const Json& row, const char* key) {
    if (!row.contains(key) || !row[key].is_number()) return {};
    return row[key].get<double>();
}

std::string text_at(const Json& row, const char* key) {
    return row.contains(key) && row[key].is_string() ? row[key].get<std::string>() : std::string();
}

std::string plot_document(const Json& report, const std::string& note, const PlotPage& page) {
    const std::size_t count = page.panels.size();
    const std::size_t columns = count > 8 ? 4 : std::clamp<std::size_t>(count, 2, 3);
    const double cell_width = margin_left + plot_width + gap,
                 cell_height = margin_top + plot_height + margin_bottom + gap;
    const double width = double(columns) * cell_width;
    std::string body =
        fmt::format("<g transform=\"translate(16 8)\">\n{}</g>\n", heading(report, note));
    for (std::size_t i = 0; i < count; ++i)
        body += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n",
                            16 + double(i % columns) * cell_width + margin_left,
                            title_height + double(i / columns) * cell_height + margin_top,
                            page.panels[i]);
    const double rows = double((count + columns - 1) / columns);
    double legend_height = 0.0;
    const std::string names = legend(page, width, legend_height);
    const double top = title_height + rows * cell_height + 12;
    body += fmt::format("<g transform=\"translate(16 {:.0f})\">\n{}</g>\n", top, names);
    return svg_document(width + 32, top + legend_height + 12, body);
}

}  // namespace burl
