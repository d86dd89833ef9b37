#pragma once
// What the tests of functions that other programs define (procedural/graph/point_function.h) share:
// gradients against differences, and both evaluations against each other.
#include <span>

#include "procedural/graph/values.h"
#include "tests/procedural/graph/cases.h"

namespace burl {

inline GraphSample sample_at(const TextureGraph& graph, const Vec3d& point) {
    const GraphEvaluator evaluate(graph);
    GraphEvaluator::Scratch scratch = evaluate.make_scratch();
    GraphSample sample;
    evaluate({&point, 1}, {}, scratch, {&sample, 1});
    return sample;
}

/// Three numbers of a sample: a number counts three times.
inline Vec3d values_of(const GraphSample& sample) {
    const auto& c = sample.channels;
    if (sample.wire == Wire::number) return Vec3d(c[0].value);
    return {c[0].value, c[1].value, c[2].value};
}

/// The gradient of channel c by differences, and whether two widths agree on it.
inline bool slope_near(const TextureGraph& graph, const Vec3d& p, std::size_t c, Vec3d& slope) {
    Vec3d coarse;
    for (int axis = 0; axis < 3; ++axis) {
        const auto by = [&](double h) {
            Vec3d a = p, b = p;
            a[axis] -= h, b[axis] += h;
            const double high = sample_at(graph, b).channels[c].value;
            return (high - sample_at(graph, a).channels[c].value) / (2.0 * h);
        };
        coarse[axis] = by(2e-5), slope[axis] = by(1e-5);
    }
    return glm::length(coarse - slope) < 2e-6 * (1.0 + glm::length(slope));
}

inline void expect_gradients_of_differences(std::span<const GraphCase> cases) {
    for (const GraphCase& one : cases) {
        const TextureGraph graph = graph_of(one.json);
        int used = 0;
        for (const Vec3d& p : random_points(25, 3.0, 7)) {
            const GraphSample sample = sample_at(graph, p);
            for (std::size_t c = 0; c < (sample.wire == Wire::number ? 1 : 3); ++c) {
                Vec3d slope;
                if (!slope_near(graph, p, c, slope)) continue;
                ++used;
                EXPECT_LT(glm::length(sample.channels[c].slope - slope),
                          1e-5 * (1.0 + glm::length(slope)))
                    << one.json;
            }
        }
        EXPECT_GT(used, 15) << one.json;
    }
}

inline void expect_values_of_the_evaluator(std::span<const GraphCase> cases) {
    for (const GraphCase& one : cases) {
        const TextureGraph graph = graph_of(one.json);
        const GraphValues values(graph);
        auto scratch = values.program().make_scratch();
        for (const Vec3d& p : random_points(40, 3.0, 3)) {
            const Vec3d exact = values_of(sample_at(graph, p));
            EXPECT_LT(glm::length(values(p, scratch) - exact), 1e-5 * (1.0 + glm::length(exact)))
                << one.json;
        }
    }
}

}  // namespace burl
