#include "app/bench/plot_shares.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bench/plot_parts.h"
#include "app/bench/svg_text.h"

namespace burl {

namespace {

constexpr double bar_height = 15, bar_step = 20, bar_length = 460, shares_title_height = 66,
                 note_width = 110;

struct Share {
    std::string group;
    double share = 0.0, error = 0.0;
};

std::vector<Share> read_shares(const Json& rows) {
    std::vector<Share> shares;
    for (const Json& row : rows) {
        if (!row.is_object()) continue;
        const auto share = number_at(row, "share");
        const std::string group = text_at(row, "group");
        if (!share || !(*share >= 0.0) || !std::isfinite(*share) || group.empty()) continue;
        shares.push_back({group, *share, number_at(row, "error").value_or(0.0)});
    }
    return shares;
}

/// Down to what is seen of the smallest, up to all that is allowed or further.
DecadeAxis axis_over(const std::vector<Share>& shares) {
    std::vector<double> values{0.1, 0.9};
    for (const Share& s : shares)
        if (s.share > 0.0) values.push_back(s.share);
    return DecadeAxis::over(values);
}

std::string grid(const DecadeAxis& axis, double height) {
    std::string svg;
    const int every = (axis.high - axis.low + 7) / 8;
    for (int e = axis.low; e <= axis.high; ++e) {
        const double x = axis.place(std::pow(10.0, e), bar_length);
        svg += svg_line(x, 0, x, height, "#dddddd");
        if ((e - axis.low) % every == 0) svg += svg_text(x, height + 14, "middle", decade_text(e));
    }
    const double all = axis.place(1.0, bar_length);
    svg += svg_line(all, -4, all, height, "#D55E00");
    return svg + svg_text(all, -8, "middle", "allowed") +
           svg_text(bar_length / 2, height + 32, "middle", "worst error over the error allowed");
}

std::string bar(const Share& share, const DecadeAxis& axis, double y) {
    const double length = share.share > 0.0 ? axis.place(share.share, bar_length) : 0.0;
    return svg_text(-8, y + bar_height - 4, "end", share.group) +
           fmt::format("<rect y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n", y,
                       length, bar_height, share.share <= 1.0 ? plot_color(0) : plot_color(1)) +
           svg_text(bar_length + 8, y + bar_height - 4, "start",
                    share.share > 0.0 ? fmt::format("error {:.2g}", share.error) : "none");
}

}  // namespace

bool has_shares(const Json& rows) {
    return !read_shares(rows).empty();
}

std::string share_plot(const Json& report, const Json& rows) {
    const std::vector<Share> shares = read_shares(rows);
    const DecadeAxis axis = axis_over(shares);
    std::size_t longest = 0;
    for (const Share& s : shares) longest = std::max(longest, s.group.size());
    const double left = 24 + svg_width(longest), height = double(shares.size()) * bar_step + 5;
    std::string inside = grid(axis, height);
    for (std::size_t i = 0; i < shares.size(); ++i)
        inside += bar(shares[i], axis, 5 + double(i) * bar_step);
    const std::string body = svg_text(16, 24, "start", "burl bench " + text_at(report, "suite"),
                                      "font-size=\"15\" font-weight=\"bold\"") +
                             fmt::format("<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n",
                                         left, shares_title_height, inside);
    return svg_document(left + bar_length + note_width, shares_title_height + height + 44, body);
}

}  // namespace burl
