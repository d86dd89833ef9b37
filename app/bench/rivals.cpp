// All methods fill the same squares of texels, which lie aslant in a cube of 16^3 cells, on one
// thread. Filling the 3-D textures is not timed, as they would be kept.
#include "app/bench/rivals.h"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/bench/noise.h"
#include "procedural/field/octave_streams.h"
#include "procedural/noise/noise.h"

namespace burl {

namespace {

constexpr double cube = 16.0;   // cells a side
constexpr double square = 8.0;  // longest side of a square of texels in cells
const Vec3d along_u = glm::normalize(Vec3d(1.0, 0.3, 0.2));
const Vec3d along_v = glm::normalize(glm::cross(Vec3d(-0.2, 0.1, 1.0), along_u));

/// Squares of side x side texels, `step` cells apart.
struct Squares {
    std::size_t side = 0;
    double step = 0.0;
    std::vector<Vec3d> origins;

    std::size_t texels() const { return origins.size() * side * side; }
    Vec3d at(std::size_t i, double x, double y) const {
        return origins[i] + step * (x * along_u + y * along_v);
    }
};

Squares squares_of(std::size_t texels_a_side, double step) {
    Squares squares{std::min(texels_a_side, std::size_t(square / step)), step, {}};
    const std::size_t count =
        std::max<std::size_t>(1, texels_a_side * texels_a_side / (squares.side * squares.side));
    for (std::size_t i = 0; i < count; ++i)
        squares.origins.emplace_back(3.0 + double(i % 5) * 0.37, 2.0 + double(i % 7) * 0.41,
                                     2.0 + double(i % 11) * 0.13);
    return squares;
}

/// Smooth value noise as an octave, in whose range kernels compute it.
const Octave& smooth_octave() {
    static const Octave octave = noise_octaves(NoiseKind::value, Fade::smooth, 1).front();
    return octave;
}

double exact_value(const Vec3d& p) {
    const Octave& octave = smooth_octave();
    return octave.scale * evaluate_noise(octave.noise, octave.lattice_from_solid(p));
}

/// The noise of rows of texels `apart` texels from one another, by a kernel.
class Rows {
  public:
    explicit Rows(Kernel kernel)
        : streams_(noise_octaves(NoiseKind::value, Fade::smooth, 1), kernel) {}

    void operator()(const Squares& squares, std::size_t i, double first, double y, double apart,
                    std::size_t count, double* out) {
        Piece piece;
        piece.solid.start = squares.at(i, first, y);
        piece.solid.step = apart * squares.step * along_u;
        piece.solid.count = count;
        piece.length = double(count);
        std::fill_n(out, count, 0.0);
        streams_.add({&piece, 1}, count, buffers_, out);
    }

  private:
    OctaveStreams streams_;
    StreamBuffers buffers_;
};

void by_kernel(const Squares& squares, Rows& rows, double* out) {
    for (std::size_t i = 0; i < squares.origins.size(); ++i)
        for (std::size_t y = 0; y < squares.side; ++y, out += squares.side)
            rows(squares, i, 0.0, double(y), 1.0, squares.side, out);
}

/// The noise at `per_cell`^3 points a cell of the cube.
class Volume {
  public:
    explicit Volume(std::size_t per_cell)
        : per_cell_(double(per_cell)), side_(per_cell * std::size_t(cube) + 1) {
        values_.reserve(side_ * side_ * side_);
        for (std::size_t z = 0; z < side_; ++z)
            for (std::size_t y = 0; y < side_; ++y)
                for (std::size_t x = 0; x < side_; ++x)
                    values_.push_back(
                        float(exact_value(Vec3d(double(x), double(y), double(z)) / per_cell_)));
    }
    std::size_t bytes() const { return values_.size() * sizeof(float); }

    float operator()(const Vec3d& p) const {
        const Vec3d place = per_cell_ * p;
        const std::size_t x = std::size_t(place.x), y = std::size_t(place.y),
                          z = std::size_t(place.z);
        const float u = float(place.x - double(x)), v = float(place.y - double(y)),
                    w = float(place.z - double(z));
        const float* corner = values_.data() + (z * side_ + y) * side_ + x;
        const auto edge = [u](const float* at) { return at[0] + u * (at[1] - at[0]); };
        const auto face = [&](const float* at) {
            return edge(at) + v * (edge(at + side_) - edge(at));
        };
        return face(corner) + w * (face(corner + side_ * side_) - face(corner));
    }

  private:
    double per_cell_;
    std::size_t side_;
    std::vector<float> values_;
};

void by_volume(const Squares& squares, const Volume& volume, double* out) {
    for (std::size_t i = 0; i < squares.origins.size(); ++i)
        for (std::size_t y = 0; y < squares.side; ++y)
            for (std::size_t x = 0; x < squares.side; ++x)
                *out++ = double(volume(squares.at(i, double(x), double(y))));
}

/// The parabola through a, b and c at 0, 1 and 2.
double parabola(double a, double b, double c, double x) {
    return a + x * ((b - a) + 0.5 * (x - 1.0) * (c - 2.0 * b + a));
}

/// Every `apart`-th texel by the kernel, the others by parabolas through three of these along v,
/// then along u.
void by_sparse_grid(const Squares& squares, Rows& rows, std::size_t apart, double* out) {
    const std::size_t columns = squares.side / apart + 3, side = squares.side;
    std::vector<double> grid(columns * columns + batch_padding), between(columns);
    for (std::size_t i = 0; i < squares.origins.size(); ++i) {
        for (std::size_t j = 0; j < columns; ++j)
            rows(squares, i, 0.0, double(j * apart), double(apart), columns,
                 grid.data() + j * columns);
        for (std::size_t y = 0; y < side; ++y) {
            const double* row = grid.data() + y / apart * columns;
            const double v = double(y % apart) / double(apart);
            for (std::size_t k = 0; k < columns; ++k)
                between[k] = parabola(row[k], row[k + columns], row[k + 2 * columns], v);
            for (std::size_t x = 0; x < side; ++x) {
                const double* at = between.data() + x / apart;
                *out++ = parabola(at[0], at[1], at[2], double(x % apart) / double(apart));
            }
        }
    }
}

std::vector<double> exact_values(const Squares& squares) {
    std::vector<double> values;
    values.reserve(squares.texels());
    for (std::size_t i = 0; i < squares.origins.size(); ++i)
        for (std::size_t y = 0; y < squares.side; ++y)
            for (std::size_t x = 0; x < squares.side; ++x)
                values.push_back(exact_value(squares.at(i, double(x), double(y))));
    return values;
}

struct RivalWay {
    std::string name;
    std::function<void(const Squares&, double*)> fill;
};

std::vector<RivalWay> rival_ways() {
    std::vector<RivalWay> all;
    for (const auto& [name, kernel] :
         {std::pair{"noise at every texel", Kernel::automatic},
          std::pair{"noise at every texel, no shared corners", Kernel::direct}})
        all.push_back({name, [rows = std::make_shared<Rows>(kernel)](
                                 const Squares& s, double* out) { by_kernel(s, *rows, out); }});
    for (const std::size_t per_cell : {1, 4, 8}) {
        const auto volume = std::make_shared<const Volume>(per_cell);
        all.push_back({fmt::format("3-D texture, {} a cell, {:.1f} MB", per_cell,
                                   double(volume->bytes()) / 1e6),
                       [volume](const Squares& s, double* out) { by_volume(s, *volume, out); }});
    }
    for (const std::size_t apart : {2, 4, 8})
        all.push_back(
            {fmt::format("sparse grid, every {} texels", apart),
             [apart, rows = std::make_shared<Rows>(Kernel::automatic)](
                 const Squares& s, double* out) { by_sparse_grid(s, *rows, apart, out); }});
    return all;
}

}  // namespace

std::vector<BenchResult> bench_rivals(int repeats, std::size_t side) {
    std::vector<BenchCase> cases;
    std::vector<BenchError> errors;
    const std::vector<RivalWay> all = rival_ways();
    for (const int cells : {64, 16, 4}) {
        const auto squares = std::make_shared<const Squares>(squares_of(side, 1.0 / cells));
        const std::vector<double> exact = exact_values(*squares);
        const auto out = std::make_shared<std::vector<double>>(exact.size() + batch_padding);
        for (const RivalWay& way : all) {
            way.fill(*squares, out->data());
            errors.push_back(BenchError::of({out->data(), exact.size()}, exact));
            cases.push_back({way.name, double(exact.size()), "texel",
                             [squares, out, fill = way.fill] { fill(*squares, out->data()); },
                             fmt::format("1/{} cell a texel", cells)});
        }
    }
    const std::vector<BenchRow> times = run_paired(cases, repeats);
    std::vector<BenchResult> results;
    for (std::size_t i = 0; i < times.size(); ++i) results.push_back({times[i], errors[i]});
    return results;
}

void run_rivals_bench(const BenchCommand& command) {
    report_results(command, bench_rivals(command.repeats, command.size_or(512)));
}

}  // namespace burl
