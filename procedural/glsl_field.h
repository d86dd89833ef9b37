#pragma once
// The field f = q + sum_i a_i n_i of a 1999 texture (Hart et al. 1999, eq. 1) as the text of a
// shader function, with the sequence of operations, and so the bits, of field_sampler.h: octaves of
// one lattice are summed in float32 from the finest to the coarsest, groups and the quadric in
// `real`. What a slider moves is a uniform: a new shader is needed only where the list of octaves
// changes.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "procedural/octave_groups.h"

namespace burl {

/// What the text depends on.
struct FieldShape {
    struct Group {
        NoiseKind kind = NoiseKind::value;
        Fade fade = Fade::smooth;
        std::size_t octaves = 0;
        bool operator==(const Group&) const = default;
    };
    std::vector<Group> groups;
    bool operator==(const FieldShape&) const = default;
};

/// The values of the uniforms of the same names. Octaves are numbered through all groups, from the
/// coarsest of each to the finest.
struct FieldUniforms {
    std::vector<std::array<std::uint32_t, 3>> seeds;  ///< for the hashes: stream_noise.glsl
    std::vector<float> weights;
    std::vector<float> radii;    ///< squared, by group
    std::vector<double> scales;  ///< by group
    double constant = 0.0;       ///< the octaves' offsets
};

FieldShape field_shape(const std::vector<OctaveGroup>& groups);
FieldUniforms field_uniforms(const std::vector<OctaveGroup>& groups,
                             std::span<const Octave> octaves);

/// Why the text cannot be: octaves that no stream kernel knows; empty where it can.
std::string no_field_shader(std::span<const Octave> octaves);

/// `real field(ivec2 texel)`, reading lattice maps (lattice_map.h) from the samplers map_cells[]
/// and map_places[], one a group or a single one where there is none. NaN where no span shows
/// anything. Stands behind real.glsl, noise_lattice.glsl, real_bits.glsl and stream_noise.glsl.
std::string glsl_field(const FieldShape& shape);

}  // namespace burl
