#pragma once
// The field f = q + sum_i a_i n_i of a 1999 texture (Hart et al. 1999, eq. 1) as the text of a
// shader function, with the sequence of operations, and so the bits, of field/sampler.h: octaves of
// one lattice are summed in float32 from the finest to the coarsest; groups, octaves without a
// stream kernel and the quadric are summed in `real`. Numbers that a slider moves are uniforms: a
// new shader is needed only where the list of octaves changes.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "procedural/field/octave_groups.h"
#include "procedural/glsl/noise.h"

namespace burl {

/// The properties of a field that its shader's text depends on.
struct FieldShape {
    struct Group {
        NoiseKind kind = NoiseKind::value;
        Fade fade = Fade::smooth;
        std::size_t octaves = 0;
        bool operator==(const Group&) const = default;
    };
    /// An octave without a stream kernel.
    struct Lone {
        NoiseSpec noise;  ///< noise with seed and time 0
        OctaveShape shape = OctaveShape::plain;
        bool operator==(const Lone&) const = default;
    };
    std::vector<Group> groups;
    std::vector<Lone> lone;
    bool operator==(const FieldShape&) const = default;

    /// The number of lattice maps that are read: one per group, or a single one for the quadric.
    std::size_t maps() const { return std::max<std::size_t>(groups.size(), 1); }
};

/// The values of the uniforms of the same names. Octaves are numbered through all groups, from the
/// coarsest of each to the finest.
struct FieldUniforms {
    /// The seeds of the hashes (shaders/noise/stream_noise.glsl).
    std::vector<std::array<std::uint32_t, 3>> seeds;
    std::vector<float> weights;
    std::vector<float> radii;    ///< squared radii, one per group
    std::vector<double> scales;  ///< one per group
    std::vector<std::uint32_t> lone_seeds;
    std::vector<double> lone_times, lone_scales;
    double constant = 0.0;  ///< sum of the octaves' offsets
};

/// The octaves of a texture, sorted into groups with stream kernels and lone octaves.
struct FieldOctaves {
    std::vector<OctaveGroup> groups;
    std::vector<Octave> lone;  ///< octaves without a stream kernel
    double constant = 0.0;     ///< sum of all offsets

    explicit FieldOctaves(const Texture& texture);
    FieldShape shape() const;
    FieldUniforms uniforms() const;
};

/// The expression of the noise of octave k of a group, number `octave` of all, at the StreamSite
/// siteN, N being the group's number; of the noise and its gradient if `sloped`.
std::string glsl_octave_noise(const FieldShape::Group& group, std::size_t number, std::size_t k,
                              std::size_t octave, bool sloped = false);

/// The functions lone_noiseN and lone_shapeN of the octaves without a stream kernel.
std::string glsl_lone_functions(const FieldShape& shape);

/// The parts that must precede the noise functions of a field.
std::vector<GlslPart> glsl_noises_of(const FieldShape& shape);

/// The declarations of a field's uniforms.
std::string glsl_field_uniforms(const FieldShape& shape);

/// The parts of a shader that end with `real field(ivec2 texel)`, which is NaN where no span shows
/// anything. It reads lattice maps (field/lattice_map.h) from the samplers map_cells[] and
/// map_places[], and point maps (maps/point_map.h) of the lone octaves' lattices from lone_xy[] and
/// lone_z[]; `map_scale` is 1 / the maps' width and height.
std::vector<GlslPart> glsl_field(const FieldShape& shape);

}  // namespace burl
