#include <cmath>
#include <memory>
#include <random>

#include <fmt/format.h>

#include "procedural/field/octave_streams.h"
#include "procedural/kernels/quadric_kernel.h"
#include "procedural/noise/names.h"
#include "tests/benchmarks/micro_benchmarks.h"

namespace burl {

namespace {

constexpr double crossings = 1.0 / 64;
constexpr std::size_t span_length = 16;

/// A batch whose coordinates and runs are ready.
std::shared_ptr<StreamBuffers> filled_buffers() {
    auto buffers = std::make_shared<StreamBuffers>();
    fill_stream({}, 0, random_spans(crossings, span_length), buffers->lattice);
    find_runs(buffers->lattice, 0, batch_capacity, buffers->runs);
    buffers->sums = {};
    return buffers;
}

std::string octave_name(NoiseKind kind, Fade fade) {
    for (const auto& named : noise_kinds) {
        if (named.value != kind) continue;
        if (kind != NoiseKind::value) return std::string(named.name);
        for (const auto& f : fade_names)
            if (f.value == fade) return fmt::format("{}/{}", named.name, f.name);
    }
    return "unknown";
}

void register_octave(NoiseKind kind, Fade fade, const std::shared_ptr<StreamBuffers>& buffers) {
    const StreamOctave octave{7, 0, 0.5f};
    const std::string name = octave_name(kind, fade);
    float* sums = buffers->sums.values;
    register_batch("direct_kernel/" + name, [=] {
        direct_kernel(kind, fade)(octave, buffers->lattice, nullptr, batch_capacity, sums, nullptr);
    });
    register_batch("sharing_kernel/" + name, [=] {
        sharing_kernel(kind, fade, false)(octave, buffers->lattice, &buffers->runs, batch_capacity,
                                          sums, nullptr);
    });
    register_batch("gradient_kernel/" + name, [=] {
        gradient_kernel(kind, fade)(octave, buffers->lattice, nullptr, batch_capacity, sums,
                                    &buffers->sums.gradients);
    });
    register_batch("sharing_gradient_kernel/" + name, [=] {
        sharing_kernel(kind, fade, true)(octave, buffers->lattice, &buffers->runs, batch_capacity,
                                         sums, &buffers->sums.gradients);
    });
}

void register_quadric() {
    const auto pieces =
        std::make_shared<const std::vector<Piece>>(random_spans(crossings, span_length));
    const auto parabolas = std::make_shared<std::vector<ParabolaLine>>(pieces->size());
    Quadric quadric;
    quadric.i = 0.5, quadric.a = 0.1;
    register_batch("make_parabolas", [=] { make_parabolas(quadric, 0.25, *pieces, *parabolas); });
    make_parabolas(quadric, 0.25, *pieces, *parabolas);
    const auto values = std::make_shared<std::vector<double>>(batch_capacity + batch_padding);
    register_batch("fill_parabolas", [=] { fill_parabolas(*parabolas, values->data()); });
    const auto slopes = std::make_shared<SlopeBatch>();
    register_batch("fill_quadric_slopes", [=] { fill_quadric_slopes(quadric, *pieces, *slopes); });
    const auto gradients = std::make_shared<GradientSums>();
    register_batch("add_slopes", [=] { add_slopes({}, 0.5, *pieces, *gradients, *slopes); });
}

}  // namespace

std::vector<Piece> random_spans(double planes_per_texel, std::size_t length) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&] {
        const double x = unit(random), y = unit(random), z = unit(random);
        return Vec3d(x, y, z);
    };
    std::vector<Piece> pieces;
    for (std::size_t left = batch_capacity; left > 0;) {
        Piece& piece = pieces.emplace_back();
        const Vec3d way = vector();
        const double planes = std::abs(way.x) + std::abs(way.y) + std::abs(way.z);
        piece.solid = {30.0 * vector(), planes_per_texel / planes * way, 0.0,
                       std::min(left, length)};
        piece.length = double(piece.solid.count);
        left -= piece.solid.count;
    }
    return pieces;
}

void register_stream_benchmarks() {
    const auto buffers = filled_buffers();
    for (const std::size_t length : {std::size_t{8}, std::size_t{32}, std::size_t{256}})
        register_batch(
            fmt::format("fill_stream/{}", length),
            [buffers = std::make_shared<StreamBuffers>(), spans = random_spans(crossings, length)] {
                fill_stream({}, 0, spans, buffers->lattice);
            });
    register_batch("find_runs", [runs = std::make_shared<CellRuns>(), buffers] {
        find_runs(buffers->lattice, 0, batch_capacity, *runs);
    });
    for (const auto& fade : fade_names) register_octave(NoiseKind::value, fade.value, buffers);
    register_octave(NoiseKind::perlin, Fade::quintic, buffers);
    register_batch("add_sums", [buffers, values = std::vector<double>(batch_capacity +
                                                                      batch_padding)]() mutable {
        add_sums(0x1p-26, buffers->sums.values, batch_capacity, values.data());
    });
    register_quadric();
}

}  // namespace burl
