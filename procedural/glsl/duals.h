#pragma once
// Texture graphs as GLSL with gradients, node by node in the graph evaluator's order
// (graph/evaluator.h): every channel of every node is a variable of type real4, a value and its
// derivatives with respect to the solid point (shaders/graph/dual.glsl).
#include <optional>

#include "procedural/glsl/map_tables.h"
#include "procedural/glsl/noise_sum.h"
#include "procedural/graph/batch.h"

namespace burl {

/// The fade of octaves that a footprint does not show: pbrt's rule, with their mean in their place.
struct GlslFade {
    double lacunarity = 2.0, mean = 0.0;
};

/// The filter and the colour maps of nodes that average over the footprint (step_u, step_v).
struct GlslFiltering {
    Filter filter;
    GlslMapTables maps;
};

/// The text of one function's body, line by line.
class GlslDuals {
  public:
    /// The text of a function whose nodes are point samples if `filtering` is null.
    GlslDuals(GlslFunctions& functions, GlslFiltering* filtering)
        : functions_(functions), sums_(functions), filtering_(filtering) {}

    GlslFunctions& functions() { return functions_; }
    GlslFiltering* filtering() { return filtering_; }
    std::string number(double value) const { return functions_.number(value); }
    /// The text "dual(value)".
    std::string constant(double value) const;

    /// Appends a line to the body.
    void line(const std::string& text);
    /// Appends a line that declares a new variable, and returns the variable's name.
    std::string dual(const std::string& expression) { return variable("exact real4", expression); }
    std::string real(const std::string& expression) { return variable("exact real", expression); }
    std::string variable(const std::string& type, const std::string& expression);
    std::string new_name(std::string_view stem);

    /// The change of x along a step of the footprint, 'u' or 'v'.
    std::string along(const std::string& x, char step) const;
    /// The width of the box that has the variance of x over the footprint.
    std::string box_width(const std::string& x) const;

    /// A sum of octaves at a point, with its gradient. Without `fade` all octaves show.
    std::string octaves(const NoiseSum& sum, const std::array<std::string, 3>& point,
                        const std::optional<GlslFade>& fade);
    /// A sum of octaves at a point of type real3 that is no node's: a vec4 of the value and its
    /// derivatives along the point's coordinates.
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

/// The names of a written node's channels, or of its point's coordinates.
struct GlslNode {
    std::vector<std::string> channels;
};

/// A node to be written, with its inputs and its point.
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

    /// The expression of d . point + offset.
    std::string along(const Vec3d& d, double offset = 0.0) const;
    /// A node whose result is a number.
    GlslNode number(const std::string& expression) const { return {{text->dual(expression)}}; }
    /// A node whose result is input 0 where the weight is 0, input 1 where it is 1.
    GlslNode blend(const std::string& weight) const;
    /// A node whose channel c is `expression(c)`.
    template <class Expression>
    GlslNode channels(const Expression& expression) const {
        GlslNode result;
        for (std::size_t c = 0; c < std::size_t(node->wire); ++c)
            result.channels.push_back(text->dual(expression(c)));
        return result;
    }
};

/// A node type's name and the function that writes its nodes.
struct NamedGlslNode {
    std::string_view node;
    GlslNode (*write)(const GlslNodeCall& call) = nullptr;
};

/// The nodes of numbers, weighted sums and mappings (dual_math.cpp).
std::span<const NamedGlslNode> glsl_math_nodes();
/// The nodes of regular patterns (dual_patterns.cpp).
std::span<const NamedGlslNode> glsl_pattern_nodes();
/// The nodes of irregular textures (dual_noise.cpp).
std::span<const NamedGlslNode> glsl_noise_nodes();
/// The nodes whose results are colours, for shaders with a footprint (dual_colors.cpp).
std::span<const NamedGlslNode> glsl_color_nodes();

/// The fractal sum of a node's parameters at `factors` times its point, with its gradient.
std::string glsl_octaves_at(const GlslNodeCall& call, const Vec3d& factors);

/// The function `real4 NAME(real3 solid)`: a graph's number at a point with its gradient, equal to
/// the evaluator's in float32 without a footprint.
std::string glsl_gradient_function(const TextureGraph& graph, const std::string& name,
                                   GlslFunctions& functions);

/// The function `real3 NAME(real3 solid, real3 step_u, real3 step_v)`: a graph's colour over the
/// footprint with these steps, in linear light over black.
std::string glsl_filtered_function(const TextureGraph& graph, const std::string& name,
                                   GlslFunctions& functions, GlslFiltering& filtering);

}  // namespace burl
