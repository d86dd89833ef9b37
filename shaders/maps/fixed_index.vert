#version 330 core
// One triangle over the whole target, as in maps/full_screen.vert. The uniforms go to the fragments
// through flat varyings, of which llvmpipe reads one number for all the texels it works on; of
// uniforms it reads one for each texel. OCTAVE_PAIRS and TERMS are the arrays' lengths.
uniform uvec4 octaves[OCTAVE_PAIRS];  // two octaves each: seed and the bits of the weight, twice
uniform uvec4 terms[TERMS];           // a FixedTerm each: the bits of `whole`, factor, shift
uniform uvec4 index;                  // constant, largest index, width of the maps in squares, colour of gaps
uniform uvec4 entry;                  // shifts that leave an entry's number and a place in it; tolerance

flat out uvec4 octave_pairs[OCTAVE_PAIRS], term_words[TERMS], index_words, entry_words;

void main() {
    gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0);
    octave_pairs = octaves;
    term_words = terms;
    index_words = index;
    entry_words = entry;
}
