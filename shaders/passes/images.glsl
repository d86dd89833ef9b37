// The passes of multipass noise over images (procedural/passes/plan.h), each a function whose value
// a texel of the target stores: integers for cells_pass, step_pass and copy_integers_pass, else
// numbers. This part must follow passes/multipass.glsl.
uniform sampler2D tables;
uniform vec2 colors;
uniform float scale, bias;
uniform bool wraps;

// The integers of the lattice coordinates: the cell's lowest corner, modulo 2^32.
uvec4 cells_pass() {
    return uvec4(cells(), 0u);
}

// The integers of the cell's opposite corner.
uvec4 step_pass() {
    return texelFetch(first_integers, texel(), 0) + 1u;
}

// The fractions of the lattice coordinates, in [0, 1].
vec4 places_pass() {
    return vec4(vec3(places()) * 2.3283064365386962890625e-10, 0.0);  // 2^-32
}

// The papers' input: coordinates as colours of b_i.b_f bits.
vec4 solid_map_pass() {
    uint fraction_bits = 8u - integer_bits;
    uvec3 coordinates = (cells() - base_cell) << fraction_bits | places() >> (32u - fraction_bits);
    return vec4(vec3(coordinates & 255u), 0.0);
}

// An image copied in the channels that the colour mask lets pass.
vec4 copy_pass() {
    return numbers(first);
}

// A corner's integers copied in the channels that the colour mask lets pass.
uvec4 copy_integers_pass() {
    return texelFetch(first_integers, texel(), 0);
}

// The luminance image of one channel of another image.
vec4 isolate_pass() {
    return vec4(numbers(first)[axis]);
}

// Scale and bias of every channel: PixelTransfer.
vec4 transfer_pass() {
    vec4 x = scale * numbers(first) + bias;
    if (wraps) x -= 256.0 * floor(x * 0.00390625);
    return x;
}

// An image added to another: blending with factors.
vec4 combine_pass() {
    return numbers(first) + (scale * numbers(second) + bias);
}

// The product of two images: modulating one with the other.
vec4 multiply_pass() {
    return product(numbers(first), numbers(second));
}

// A corner's random number times its weight along one axis, or times the weight's complement.
vec4 weigh_pass() {
    float weight = numbers(second)[axis];
    return product(numbers(first), vec4(upper ? weight : one - weight));
}

// A logical shift to the left: the highest bit is dropped, the others double.
vec4 shift_left_pass() {
    vec4 x = numbers(first);
    return 2.0 * (x - 128.0 * step(128.0, x));
}

// One of two luminances, chosen by an image's highest bit, blended over another image with alpha
// 1/8.
vec4 blend_bit_pass() {
    vec4 over = mix(vec4(colors.x), vec4(colors.y), greaterThanEqual(numbers(first), vec4(128.0)));
    return floor((7.0 * numbers(second) + over + 4.0) * 0.125);
}

// A random number by one coordinate of a corner: the papers' PixelMap.
vec4 axis_table_pass() {
    uint cell = lattice_cells(upper ? 1u : 0u)[axis];
    return vec4(texelFetch(tables, ivec2(cell & 255u, 0), 0)[axis]);
}

// A random number by a sum of random numbers (the papers' PixelMap), or a histogram equalised.
vec4 value_table_pass() {
    float x = numbers(first).x;
    int number = int(floor(x * (255.0 / one) + 0.5));
    return vec4(texelFetch(tables, ivec2(number, 0), 0).w);
}
