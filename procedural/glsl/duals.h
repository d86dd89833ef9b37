#pragma once
// Texture graphs as GLSL with gradients, node by node as the graph evaluator walks them
// (graph_evaluator.h): every channel of every node is a variable of type real4, a value and its
// derivatives with respect to the solid point (shaders/graph/dual.glsl).
#include <optional>

#include "procedural/glsl/map_tables.h"
#include "procedural/glsl/noise_sum.h"
#include "procedural/graph/batch.h"

namespace burl {

/// How octaves that a footprint does not show fade: pbrt's rule, leaving their mean behind.
struct GlslFade {
    double lacunarity = 2.0, mean = 0.0;
};

/// What nodes need to average over the footprint (step_u, step_v).
struct GlslFiltering {
    Filter filter;
    GlslMapTables maps;
};

/// The text of one function's body, line by line.
class GlslDuals {
  public:
    /// No `filtering`: point samples.
    GlslDuals(GlslFunctions& functions, GlslFiltering* filtering)
        : functions_(functions), sums_(functions), filtering_(filtering) {}

    GlslFunctions& functions() { return functions_; }
    GlslFiltering* filtering() { return filtering_; }
    std::string number(double value) const { return functions_.number(value); }
    /// "dual(value)".
    std::string constant(double value) const;

    void line(const std::string& text);
    /// A new variable of that value; its name.
    std::string dual(const std::string& expression) { return variable("exact real4", expression); }
    std::string real(const std::string& expression) { return variable("exact real", expression); }
    std::string variable(const std::string& type, const std::string& expression);
    std::string new_name(std::string_view stem);

    /// How much x changes across the footprint along its two steps.
    std::string along(const std::string& x, char step) const;
    /// Width of the box with the variance of x over the footprint.
    std::string box_width(const std::string& x) const;

    /// A sum of octaves at a point, with its gradient. No `fade`: all of them, always.
    std::string octaves(const NoiseSum& sum, const std::array<std::string, 3>& point,
                        const std::optional<GlslFade>& fade);
    /// The same at a point of type real3 that is no node's: a vec4 with derivatives along it.
    std::string lattice_octaves(const NoiseSum& sum, const std::string& point);

    const std::string& lines() const { return lines_; }

  private:
    std::string visible(std::size_t octaves, double lacunarity,
                        const std::array<std::string, 3>& point);

    GlslFunctions& functions_;
    GlslNoiseSums sums_;
    GlslFiltering* filtering_;
    std::string lines_;
    std::size_t variables_ = 0;
};

/// What a node became: names of its channels or of a point's coordinates.
struct GlslNode {
    std::vector<std::string> channels;
};

/// One node to be written, and what it may use.
struct GlslNodeCall {
    const TextureGraph* graph = nullptr;
    const GraphNode* node = nullptr;
    std::array<const GlslNode*, 4> inputs{};
    const GlslNode* place = nullptr;
    GlslDuals* text = nullptr;

    double parameter(std::string_view key, std::size_t component = 0) const;
    Vec3d vector(std::string_view key) const;
    /// Channel c of input k; a number where a colour is wanted is an opaque grey.
    std::string input(std::size_t k, std::size_t c = 0) const;
    const std::string& axis(std::size_t i) const { return place->channels[i]; }
    std::array<std::string, 3> point() const { return {axis(0), axis(1), axis(2)}; }

    /// d . point + offset.
    std::string along(const Vec3d& d, double offset = 0.0) const;
    /// One number.
    GlslNode number(const std::string& expression) const { return {{text->dual(expression)}}; }
    /// Input 0 where the weight is 0, input 1 where it is 1.
    GlslNode blend(const std::string& weight) const;
    /// `expression(c)` for each channel.
    template <class Expression>
    GlslNode channels(const Expression& expression) const {
        GlslNode result;
        for (std::size_t c = 0; c < std::size_t(node->wire); ++c)
            result.channels.push_back(text->dual(expression(c)));
        return result;
    }
};

struct NamedGlslNode {
    std::string_view node;
    GlslNode (*write)(const GlslNodeCall& call) = nullptr;
};

/// glsl_dual_math.cpp: numbers, weighted sums and mappings.
std::span<const NamedGlslNode> glsl_math_nodes();
/// glsl_dual_patterns.cpp
std::span<const NamedGlslNode> glsl_pattern_nodes();
/// glsl_dual_noise.cpp
std::span<const NamedGlslNode> glsl_noise_nodes();
/// glsl_dual_colors.cpp: nodes that give colours alone, where there is a footprint.
std::span<const NamedGlslNode> glsl_color_nodes();

/// The fractal sum of a node's parameters at `factors` times its point, with its gradient.
std::string glsl_octaves_at(const GlslNodeCall& call, const Vec3d& factors);

/// `real4 NAME(real3 solid)`: a graph's number at a point, with its gradient, as the evaluator has
/// it in float32 without a footprint.
std::string glsl_gradient_function(const TextureGraph& graph, const std::string& name,
                                   GlslFunctions& functions);

/// `real3 NAME(real3 solid, real3 step_u, real3 step_v)`: a graph's colour over the footprint with
/// these steps, linear light over black.
std::string glsl_filtered_function(const TextureGraph& graph, const std::string& name,
                                   GlslFunctions& functions, GlslFiltering& filtering);

}  // namespace burl
