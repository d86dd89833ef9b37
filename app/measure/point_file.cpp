#include "app/measure/point_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "app/base/file_bytes.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

std::string_view trimmed(std::string_view text) {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> split_cells(std::string_view line) {
    std::vector<std::string_view> cells;
    for (;;) {
        const std::size_t comma = line.find(',');
        cells.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) return cells;
        line.remove_prefix(comma + 1);
    }
}

std::optional<double> parse_number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (wrong != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

/// The beginning of the text, at most 40 characters, without control and other non-ASCII
/// characters.
std::string shown(std::string_view text) {
    std::string result(text.substr(0, 40));
    for (char& c : result)
        if (c < ' ' || c > '~') c = '?';
    return "'" + result + (text.size() > 40 ? "...'" : "'");
}

/// A parser of lines; the first line chooses the columns of coordinates.
class PointReader {
  public:
    explicit PointReader(const std::string& path) : path_(path) {}

    void read_line(std::string_view line, std::size_t number) {
        line = trimmed(line);
        if (line.empty() || line.starts_with('#')) return;
        const std::vector<std::string_view> cells = split_cells(line);
        if (columns_.empty() && !choose_columns(cells, number)) return;
        if (cells.size() != cell_count_)
            throw invalid_file(path_, number,
                               fmt::format("the line has {} columns, the first one {}",
                                           cells.size(), cell_count_));
        std::array<double, 4> point{};
        for (std::size_t axis = 0; axis < columns_.size(); ++axis)
            point[axis] = coordinate(cells[columns_[axis]], number);
        file_.points.push_back(point);
    }

    PointFile result() && {
        if (file_.points.empty())
            throw invalid_file(path_, 0, "has no points; write lines of x,y,z or x,y,z,w");
        file_.dimensions = columns_.size();
        return std::move(file_);
    }

  private:
    /// Chooses the columns from the first line; false when it was a line of names.
    bool choose_columns(const std::vector<std::string_view>& cells, std::size_t number) {
        cell_count_ = cells.size();
        const bool numbers = parse_number(cells[0]).has_value();
        if (numbers) {
            if (cells.size() > 4)
                throw invalid_file(
                    path_, number,
                    fmt::format("{} columns without names; at most x,y,z,w", cells.size()));
            for (std::size_t i = 0; i < cells.size(); ++i) columns_.push_back(i);
            return true;
        }
        for (const std::string_view name : {"x", "y", "z", "w"}) {
            const auto found = std::find(cells.begin(), cells.end(), name);
            if (found == cells.end()) break;
            columns_.push_back(std::size_t(found - cells.begin()));
        }
        if (columns_.empty())
            throw invalid_file(
                path_, number,
                fmt::format("{} is no number, and no column is named x", shown(cells[0])));
        return false;
    }

    double coordinate(std::string_view cell, std::size_t number) const {
        const std::optional<double> value = parse_number(cell);
        if (!value) throw invalid_file(path_, number, fmt::format("{} is no number", shown(cell)));
        if (!std::isfinite(*value))
            throw invalid_file(path_, number, fmt::format("{} is not finite", shown(cell)));
        return *value;
    }

    std::string path_;
    PointFile file_;
    /// The columns of x, y, z, w; empty until a line was read.
    std::vector<std::size_t> columns_;
    std::size_t cell_count_ = 0;
};

}  // namespace

PointFile read_points(const std::string& path) {
    const std::vector<std::uint8_t> bytes = read_file_bytes(path);
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    PointReader reader(path);
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        reader.read_line(text.substr(0, end), number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return std::move(reader).result();
}

}  // namespace burl
