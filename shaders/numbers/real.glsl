// The numbers of a shader that has the host's bits; the first part of a shader. `real` is float64
// where the context has it, for coordinates and sums; otherwise float32, with which results agree
// to 2e-6. `exact` keeps a compiler from reordering the operations behind a variable ((a + b) - b
// is not a). BURL_FLOAT64, defined before as 1 or 0, decides; or BURL_FLOAT32, which stands for 0.
#if defined(BURL_FLOAT32) && !defined(BURL_FLOAT64)
#define BURL_FLOAT64 0
#endif
#ifndef BURL_FLOAT64
#extension GL_ARB_gpu_shader_fp64 : enable
#ifdef GL_ARB_gpu_shader_fp64
#define BURL_FLOAT64 1
#else
#define BURL_FLOAT64 0
#endif
#endif
#extension GL_ARB_gpu_shader5 : enable

#ifndef real
#if BURL_FLOAT64
#define real double
#define real2 dvec2
#define real3 dvec3
#define real4 dvec4
#else
#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4
#endif
#endif
#define REAL_IS_DOUBLE BURL_FLOAT64

#ifdef GL_ARB_gpu_shader5
#define exact precise
#else
#define exact
#endif

// Reals in arrays that a variable indexes are of type `real_item`, vectors of four of type `real4_item`:
// NVIDIA's compiler (580.159) keeps such arrays of float64 in float32, so they are bits.
#if REAL_IS_DOUBLE
#define real_item uvec2
struct real4_item {
    uvec4 low, high;
};
uvec2 to_item(double x) {
    return unpackDouble2x32(x);
}
double from_item(uvec2 bits) {
    return packDouble2x32(bits);
}
real4_item to_item(dvec4 v) {
    return real4_item(uvec4(unpackDouble2x32(v.x), unpackDouble2x32(v.y)),
                   uvec4(unpackDouble2x32(v.z), unpackDouble2x32(v.w)));
}
dvec4 from_item(real4_item bits) {
    return dvec4(packDouble2x32(bits.low.xy), packDouble2x32(bits.low.zw),
                 packDouble2x32(bits.high.xy), packDouble2x32(bits.high.zw));
}
#else
#define real_item float
#define real4_item vec4
#define to_item(x) (x)
#define from_item(x) (x)
#endif

// The square root, rounded to the nearest number where reals are float64: OpenGL's own need not be,
// so a step of Newton's follows, whose remainder is exact, since products of a root's halves are.
#if REAL_IS_DOUBLE
double nearest_root(double x) {
    double root = sqrt(x);
    double high = packDouble2x32(uvec2(unpackDouble2x32(root).x & 0xf8000000u, unpackDouble2x32(root).y));
    precise double low = root - high;
    precise double rest = ((x - high * high) - 2.0lf * (high * low)) - low * low;
    precise double nearer = root + rest / (2.0lf * root);
    return root > 0.0lf && root < 1e150lf ? nearer : root;
}

float nearest_root(float x) {
    return float(nearest_root(double(x)));
}
#else
float nearest_root(float x) {
    return sqrt(x);
}
#endif
