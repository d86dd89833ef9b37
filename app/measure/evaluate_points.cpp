#include "app/measure/evaluate_points.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "app/base/file_bytes.h"
#include "app/pipeline/mesh_shape.h"
#include "app/recipe/lattice_check.h"
#include "atlas/base/error.h"
#include "atlas/base/stop.h"
#include "atlas/base/utf8.h"
#include "procedural/color/table.h"
#include "procedural/fixed/field.h"
#include "procedural/graph/evaluator.h"
#include "procedural/model/octaves.h"

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

/// The beginning of the text, as messages quote it.
std::string shown(std::string_view text) {
    return fmt::format("'{}'", legible(text, 40));
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

template <class Real, std::size_t N>
Evaluation evaluate_at(const NoiseOptions& noise, const std::array<double, 4>& point) {
    Point<N> p;
    std::copy_n(point.begin(), N, p.begin());
    const NoiseSample<Real, N> n = sample_noise<Real>(noise, p);
    return {double(n.value), {n.gradient.begin(), n.gradient.end()}, {}};
}

template <std::size_t N>
std::vector<PointResult> evaluate_all(const NoiseOptions& noise, const PointFile& file) {
    std::vector<PointResult> results;
    for (const auto& point : file.points)
        results.push_back(
            {evaluate_at<double, N>(noise, point), evaluate_at<float, N>(noise, point)});
    return results;
}

std::vector<PointResult> evaluate_all(const NoiseOptions& noise, const PointFile& file) {
    switch (file.dimensions) {
        case 1:
            return evaluate_all<1>(noise, file);
        case 2:
            return evaluate_all<2>(noise, file);
        case 3:
            return evaluate_all<3>(noise, file);
        default:
            return evaluate_all<4>(noise, file);
    }
}

/// The sum of octaves as the noise of a texture.
Texture texture_of(const NoiseOptions& options) {
    NoiseTerm term;
    term.kind = options.noise.kind, term.fade = options.noise.fade, term.seed = options.noise.seed;
    term.shape = options.fractal.shape, term.normalized = options.fractal.normalized;
    term.octaves = options.fractal.octaves, term.gain = options.fractal.gain;
    term.lacunarity = options.fractal.lacunarity;
    term.range = term.shape == OctaveShape::plain ? NoiseRange::bipolar : NoiseRange::unit;
    Texture texture;
    texture.noise = {term};
    return texture;
}

/// A recipe prepared for many points.
struct PreparedRecipe {
    Quadric quadric;
    std::vector<Octave> octaves;
    PreparedColorMap colors;
    Affine3 map;
};

/// The evaluation with every number rounded to Real.
template <class Real>
Evaluation rounded(double value, const Vec3d& gradient, const Vec3d& color) {
    const auto real = [](double x) { return double(Real(x)); };
    return {real(value),
            {real(gradient.x), real(gradient.y), real(gradient.z)},
            Vec3d(real(color.x), real(color.y), real(color.z))};
}

template <class Real>
Evaluation evaluate_at(const PreparedRecipe& recipe, const Vec3d& point) {
    const FieldSample f = sample_field<Real>(recipe.quadric, recipe.octaves, recipe.map(point));
    return rounded<Real>(f.value, f.gradient * recipe.map.linear, recipe.colors(f.value));
}

Evaluation evaluate_fixed(const PreparedRecipe& recipe, const FixedField& field,
                          const Vec3d& point) {
    const double f = field(recipe.map(point));
    return {f, {}, recipe.colors(f)};
}

std::vector<Vec3d> places_of(const PointFile& file) {
    std::vector<Vec3d> places;
    for (const auto& [x, y, z, w] : file.points) places.emplace_back(x, y, z);
    return places;
}

/// Evaluates a graph at point number `number`, of which `masks` has the values; the value of a
/// colour is its luminance (ITU-R BT.709).
template <class Real>
Evaluation evaluate_graph(const GraphEvaluator& evaluate, GraphEvaluator::Scratch& scratch,
                          const Affine3& map, const Vec3d& point, const MaskValues& masks,
                          std::size_t number) {
    scratch.masks.clear();
    for (const std::vector<Dual>& mask : masks) scratch.masks.push_back({mask[number]});
    const Vec3d s = map(point);
    GraphSample sample;
    evaluate({&s, 1}, {}, scratch, {&sample, 1});
    const auto& c = sample.channels;
    const Dual value =
        sample.wire == Wire::number ? c[0] : 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    return rounded<Real>(value.value, value.slope * map.linear, sample.color());
}

std::vector<PointResult> evaluate_graph(const Recipe& recipe, const PointFile& file,
                                        const Mesh* mesh, const std::stop_token& stop) {
    if (const std::string mask = first_mask_node(recipe.texture, GraphOutput::color);
        !mesh && !mask.empty())
        throw Error(ExitCode::unsupported,
                    fmt::format("texture: {}; name the mesh with --mesh", no_texels_for(mask)));
    const std::vector<Vec3d> points = places_of(file);
    MaskValues masks;
    if (mesh) {
        const MeshShape shape(*mesh, solid_from_mesh(*mesh, recipe.solid.space));
        masks = masks_at(shape, recipe, recipe.texture, points);
    }
    const Filter filter{FilterKind::trapezoid};
    const GraphEvaluator exact(recipe.texture, filter),
        quick(recipe.texture, filter, PrecisionKind::float32);
    GraphEvaluator::Scratch scratch = exact.make_scratch();
    const Affine3 map = texture_from_solid(recipe);
    std::vector<PointResult> results;
    for (std::size_t i = 0; i < points.size(); ++i) {
        check_stop(stop);
        results.push_back({evaluate_graph<double>(exact, scratch, map, points[i], masks, i),
                           evaluate_graph<float>(quick, scratch, map, points[i], masks, i)});
    }
    return results;
}

/// The values of a recipe of which `texture` is the plain texture.
std::vector<PointResult> evaluate_model(const Recipe& recipe, const Texture& texture,
                                        const PointFile& file) {
    const PreparedRecipe prepared{texture.quadric, expand_octaves(texture),
                                  PreparedColorMap(texture.colors), texture_from_solid(recipe)};
    std::optional<FixedField> fixed;
    if (recipe.precision.kind == PrecisionKind::fixed)
        fixed.emplace(texture, recipe.precision.format);
    std::vector<PointResult> results;
    for (const auto& [x, y, z, w] : file.points) {
        const Vec3d point(x, y, z);
        results.push_back(
            {evaluate_at<double>(prepared, point), fixed ? evaluate_fixed(prepared, *fixed, point)
                                                         : evaluate_at<float>(prepared, point)});
    }
    return results;
}

/// Throws Error(unsupported) where an octave has lattice coordinates beyond farthest_cell.
void check_reach(const NoiseOptions& noise, const PointFile& file) {
    const double finest =
        std::pow(std::max(noise.fractal.lacunarity, 1.0), double(noise.fractal.octaves) - 1.0);
    for (std::size_t i = 0; i < file.points.size(); ++i)
        for (const double x : file.points[i]) {
            const double reach = finest * (std::abs(x) + std::abs(noise.warp));
            if (reach <= farthest_cell) continue;
            throw Error(
                ExitCode::unsupported,
                fmt::format("point {}: the noise reaches {:.2g} lattice cells from the origin, and "
                            "beyond 2^46 (7e13) cells too little of a place within its cell is "
                            "left; use points nearer to the origin, fewer octaves or a smaller "
                            "lacunarity",
                            i + 1, reach));
        }
}

/// The results without the other precision, which would be float64 again.
std::vector<PointResult> only_float64(std::vector<PointResult> results) {
    for (PointResult& result : results) result.other.reset();
    return results;
}

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

std::vector<PointResult> evaluate_points(NoiseOptions noise, const PointFile& file,
                                         const Precision& precision) {
    noise.resolve(file.dimensions);
    check_reach(noise, file);
    std::vector<PointResult> results = evaluate_all(noise, file);
    if (precision.kind == PrecisionKind::float64) return only_float64(std::move(results));
    if (precision.kind != PrecisionKind::fixed) return results;
    if (file.dimensions != 3 || noise.warp != 0.0 || !has_fixed_point(noise.noise))
        throw Error(ExitCode::usage,
                    "--precision fixed is for value and perlin noise in 3 dimensions, without "
                    "period or warp");
    const FixedField field(texture_of(noise), precision.format);
    for (std::size_t i = 0; i < results.size(); ++i) {
        const auto& [x, y, z, w] = file.points[i];
        results[i].other = Evaluation{field({x, y, z}), {}, {}};
    }
    return results;
}

std::vector<PointResult> evaluate_points(const Recipe& recipe, const PointFile& file,
                                         const Mesh* mesh, const std::stop_token& stop) {
    if (file.dimensions != 3)
        throw Error(
            ExitCode::usage,
            fmt::format("a recipe needs points x,y,z; these have {} coordinates", file.dimensions));
    for (const auto& [x, y, z, w] : file.points) {
        check_stop(stop);
        const Vec3d s = texture_from_solid(recipe)(Vec3d(x, y, z));
        check_lattice(recipe, Box3{s, s});
    }
    const Texture* texture = plain_texture(recipe.texture);
    std::vector<PointResult> results =
        texture ? evaluate_model(recipe, *texture, file) : evaluate_graph(recipe, file, mesh, stop);
    if (recipe.precision.kind == PrecisionKind::float64) return only_float64(std::move(results));
    return results;
}

}  // namespace burl
