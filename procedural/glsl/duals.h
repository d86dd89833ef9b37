#pragma once
// Texture graphs as GLSL with gradients: the steps of a graph's program (graph/program.h), one
// variable of type real4 for each register, which holds a value and its derivatives with respect to
// the solid point (shaders/graph/dual.glsl).
#include "procedural/batch/filter.h"
#include "procedural/color/map_pieces.h"
#include "procedural/glsl/noise_sum.h"
#include "procedural/glsl/text.h"
#include "procedural/graph/program.h"
#include "procedural/model/octaves.h"

namespace burl {

/// The pieces and breaks of a shader's colour maps (color/map_pieces.h) as constant arrays, for
/// shaders/graph/dual_map.glsl.
class GlslMapTables {
  public:
    explicit GlslMapTables(GlslReal real) : real_(real) {}

    /// Adds a map and returns the expression, of type PieceMap, that stands for it.
    std::string add(const ColorMap& map);
    /// The declarations of the arrays, none of them empty.
    std::string text() const;

  private:
    GlslReal real_;
    std::vector<MapPieces::Piece> pieces_;
    std::vector<MapBreak> breaks_;
};

/// The text of one function's body, step by step.
class GlslDuals {
  public:
    /// Steps average over the footprint (step_u, step_v) by `filter`; they are point samples if it
    /// is null. Colour maps are added to `maps`.
    GlslDuals(GlslFunctions& functions, GlslMapTables& maps, const Filter* filter)
        : functions_(functions), sums_(functions), maps_(maps), filter_(filter) {}

    /// Writes the steps of a graph and returns the names of its number, or of red, green and blue.
    std::vector<std::string> write(const TextureGraph& graph);
    const std::string& lines() const { return lines_; }

  private:
    using Names = std::vector<std::string>;

    // The functions that write a step and return the names of its outputs. Arithmetic is in
    // duals.cpp, noise in dual_noise.cpp, cells and shapes in tiles.cpp, boards and colours in
    // dual_colors.cpp.
    Names step(const ValueOperation& work);
    Names step(const BoxMean& mean);
    Names step(const BoxPulse& pulse);
    Names step(const BoxStep& share);
    Names step(const PositiveTurn& turn);
    Names step(const SlopeAlong& slope);
    Names step(const Checkerboard& board);
    Names step(const OctaveSum& octaves);
    Names step(const SimplexOctaves& octaves);
    Names step(const CurlOctaves& octaves);
    Names step(const FieldAt& field);
    Names step(const MapColors& colors);
    Names step(const MarbleColors& colors);
    Names step(const DotsWeight& dots);
    Names step(const CellNumber& number);
    Names step(const CellFeature& feature);
    Names step(const ScatteredShapes& shapes);
    Names step(const ImageColors& image);
    Names step(const MaskRead& read);
    Names step(const PointFunction& function);

    const std::string& in(std::size_t k) const { return inputs_[k]; }
    std::string expression(const ValueOperation& work) const;
    std::string sum(const std::vector<double>& factors, double offset = 0.0) const;
    std::string inputs_of(const char* function) const;
    std::string stripes_of(Antialiasing antialiasing, const std::string& x);
    std::string supersampled(std::size_t axes) const;
    /// Writes a variable of type DualColor and returns its three channels.
    Names color(const std::string& expression);

    /// The names of variables of a field's value and of its gradient by the point's coordinates.
    struct Field {
        std::string value, gradient;
    };
    std::string at_lattice(const Affine3& lattice);
    std::string lattice_octaves(const NoiseSum& sum, const std::string& point);
    std::string point_gradient(const std::string& noise, const Mat3d& lattice) const;
    std::string moved_by(const Mat3d& linear, char step) const;
    std::string quadric(const Quadric& q, const Field& f);
    void add_octaves(std::span<const Octave> octaves, const Field& f);
    void add_faded_octaves(std::span<const Octave> octaves, const Field& f);

    std::string number(double value) const { return functions_.number(value); }
    /// The text "dual(value)".
    std::string constant(double value) const;
    /// The text "real3(x, y, z)".
    std::string real3(const Vec3d& v) const;
    void line(const std::string& text);
    /// Writes a variable with that value and returns its name.
    std::string dual(const std::string& expression) { return variable("exact real4", expression); }
    std::string variable(const std::string& type, const std::string& expression);
    std::string new_name(std::string_view stem);

    /// The footprint's two steps; 0 for point samples.
    std::array<std::string, 2> steps() const;
    /// The change of x across the footprint along its step `u` or `v`.
    std::string along(const std::string& x, char step) const;
    /// The width of the box with the variance of x over the footprint.
    std::string box_width(const std::string& x) const;

    GlslFunctions& functions_;
    GlslNoiseSums sums_;
    GlslMapTables& maps_;
    const Filter* filter_;
    std::string lines_;
    std::size_t variables_ = 0;
    Names inputs_;  ///< inputs of the step that is being written
};

/// The function `real4 NAME(real3 solid)`: a graph's number at a point, with its gradient, as the
/// evaluator has it in float32 without a footprint. Its colour maps are added to `maps`.
std::string glsl_gradient_function(const TextureGraph& graph, const std::string& name,
                                   GlslFunctions& functions, GlslMapTables& maps);

/// The function `real3 NAME(real3 solid, real3 step_u, real3 step_v)`: a graph's colour over the
/// footprint with these steps, linear light over black. Its colour maps are added to `maps`.
std::string glsl_filtered_function(const TextureGraph& graph, const std::string& name,
                                   const Filter& filter, GlslFunctions& functions,
                                   GlslMapTables& maps);

}  // namespace burl
