// A colour map's index in fixed point (procedural/fixed/index.h) and its 8-bit colours
// (procedural/fixed/colors.h), from maps in the order of procedural/maps/site_map.h. This part must
// follow noise/stream_noise.glsl. ENTRY_MARGIN is FixedColors::margin, COLOR_REPEATS 1 or 0.
uniform usamplerBuffer color_entries;
flat in uvec4 octave_pairs[OCTAVE_PAIRS], term_words[TERMS], index_words, entry_words;

const uint no_base = 0x80000000u;
const uint undecided = 0xff000000u;  // bits that mark a colour as undecided

// A texel's number in the maps: squares of 64 x 64 texels, in them blocks of 4 x 4.
int texel_place(ivec2 texel) {
    int square = (texel.y >> 6) * int(index_words.z) + (texel.x >> 6);
    return square << 12 | (texel.y & 60) << 6 | (texel.x & 60) << 2 | (texel.y & 3) << 2 | texel.x & 3;
}

HashSite map_site(uvec4 texel) {
    return HashSite(texel.x, texel.yzw);
}

// The change of the index by a group's sum.
int fixed_term(float sum, uvec4 term) {
    exact float whole = sum * uintBitsToFloat(term.x);
    int upper, lower;
    imulExtended(int(whole), int(term.y), upper, lower);
    return upper << int(term.z);
}

// The code r + 2^8 g + 2^16 b of an index, with the bits `undecided` near to a change.
uint fixed_color(int index) {
#if !COLOR_REPEATS
    index = clamp(index, 0, int(index_words.y));
#endif
    uint t = uint(index), tolerance = entry_words.z;
    uvec4 entry = texelFetch(color_entries, int(t >> entry_words.x));
    uint place = (t << entry_words.y >> 17) + ENTRY_MARGIN;
    uint first = entry.w & 0xffffu, second = entry.w >> 16;
    uint code = place >= second ? entry.z : place >= first ? entry.y : entry.x;
    bool near = place - first + tolerance <= 2u * tolerance || place - second + tolerance <= 2u * tolerance;
    return near ? code | undecided : code;
}
