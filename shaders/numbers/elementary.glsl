// Sine, angle, logarithm and power from additions, multiplications, one division or square root, as
// in procedural/numbers/elementary-inl.h: in double with the same bits, in float by shorter series
// with the errors stated here. This part must follow numbers/real.glsl.

#if REAL_IS_DOUBLE

// sin(x), x in radians, to within 1e-13 + 2^-50 |x|; 0 from |x| = 2^50 on.
double sine(double x) {
    // Adding 1.5 2^52 rounds to a whole number, whose lowest bit is the sum's.
    exact double shifted = x * 0.31830988618379067lf + 6755399441055744.0lf;
    exact double turns = shifted - 6755399441055744.0lf;
    // pi in three parts, of which the first two have 24 bits.
    exact double rest = x - turns * (4.0lf * 7.85398125648498535156e-1lf);
    rest = rest - turns * (4.0lf * 3.77489470793079817668e-8lf);
    rest = rest - turns * (4.0lf * 2.69515142907905952645e-15lf);
    if (!(abs(x) < 1125899906842624.0lf)) rest = 0.0lf;  // 2^50
    exact double z = rest * rest;
    exact double result = rest * (1.0lf + z * (-1.0lf / 6.0lf + z * (1.0lf / 120.0lf
        + z * (-1.0lf / 5040.0lf + z * (1.0lf / 362880.0lf + z * (-1.0lf / 39916800.0lf
        + z * (1.0lf / 6227020800.0lf + z * (-1.0lf / 1307674368000.0lf
        + z * (1.0lf / 355687428096000.0lf + z * (-1.0lf / 121645100408832000.0lf))))))))));
    return (unpackDouble2x32(shifted).x & 1u) == 0u ? result : -result;
}

// The angle of (x, y) in [-pi, pi] radians, to within 1e-13; 0 at the origin.
double angle(double y, double x) {
    const double pi = 3.141592653589793lf;
    bool steep = abs(y) > abs(x);
    double high = steep ? abs(y) : abs(x), low = steep ? abs(x) : abs(y);
    exact double q = low / high;
    if (!(high > 0.0lf)) q = 0.0lf;
    // The nearest of the angles 0, pi / 8 and pi / 4, to which the series adds the rest.
    bool first = q > 0.19891236737965801lf, second = q > 0.66817863791929891lf;
    double t = second ? 1.0lf : first ? 0.41421356237309503lf : 0.0lf;
    double near = second ? pi / 4.0lf : first ? pi / 8.0lf : 0.0lf;
    exact double r = (q - t) / (1.0lf + q * t);
    exact double z = r * r;
    exact double result = near + r * (1.0lf + z * (-1.0lf / 3.0lf + z * (1.0lf / 5.0lf
        + z * (-1.0lf / 7.0lf + z * (1.0lf / 9.0lf + z * (-1.0lf / 11.0lf + z * (1.0lf / 13.0lf
        + z * (-1.0lf / 15.0lf + z * (1.0lf / 17.0lf)))))))));
    if (steep) result = pi / 2.0lf - result;
    if (x < 0.0lf) result = pi - result;
    return unpackDouble2x32(y).y >> 31 != 0u ? -result : result;
}

// log2(x) of a normal number x > 0, to within 1e-13 + 2^-52 |log2(x)|.
double binary_log(double x) {
    uvec2 bits = unpackDouble2x32(x);
    exact double exponent = double(int(bits.y >> 20) - 1023);
    exact double m = packDouble2x32(uvec2(bits.x, (bits.y & 0xfffffu) | 0x3ff00000u));
    if (m > 1.4142135623730951lf) {
        m = m * 0.5lf;
        exponent = exponent + 1.0lf;
    }
    exact double s = (m - 1.0lf) / (m + 1.0lf);
    exact double z = s * s;
    exact double result = exponent + (s * 2.8853900817779268lf)
        * (1.0lf + z * (1.0lf / 3.0lf + z * (1.0lf / 5.0lf + z * (1.0lf / 7.0lf + z * (1.0lf / 9.0lf
        + z * (1.0lf / 11.0lf + z * (1.0lf / 13.0lf + z * (1.0lf / 15.0lf + z * (1.0lf / 17.0lf)))))))));
    return result;
}

// 2^x to a relative error of 1e-13; 0 below -1022, infinite from 1023.5 on.
double binary_power(double x) {
    bool low = x < -1022.0lf, high = x >= 1023.5lf;
    double y = low || high ? 0.0lf : x;
    exact double whole = roundEven(y);
    exact double r = (y - whole) * 0.69314718055994531lf;
    exact double result = packDouble2x32(uvec2(0u, uint(int(whole) + 1023) << 20))
        * (1.0lf + r * (1.0lf + r * (1.0lf / 2.0lf + r * (1.0lf / 6.0lf + r * (1.0lf / 24.0lf
        + r * (1.0lf / 120.0lf + r * (1.0lf / 720.0lf + r * (1.0lf / 5040.0lf + r * (1.0lf / 40320.0lf
        + r * (1.0lf / 362880.0lf + r * (1.0lf / 3628800.0lf + r * (1.0lf / 39916800.0lf))))))))))));
    return high ? packDouble2x32(uvec2(0u, 0x7ff00000u)) : low ? 0.0lf : result;
}

const double least_normal = 2.2250738585072014e-308lf, quarter_turn = 1.5707963267948966lf;  // pi / 2

#else

// sin(x), x in radians, to within 3e-7 for |x| < 2^15.
float sine(float x) {
    exact float turns = roundEven(x * 0.318309886);
    exact float rest = x - turns * 3.140625;  // pi in four parts, of which the first two have 9 bits
    rest = rest - turns * 9.6702575683593750e-4;
    rest = rest - turns * 6.2771141529083252e-7;
    rest = rest - turns * 1.2154201256553420e-10;
    exact float z = rest * rest;
    exact float result = rest + rest * (z * (-1.0 / 6.0 + z * (1.0 / 120.0 + z * (-1.0 / 5040.0
        + z * (1.0 / 362880.0 + z * (-1.0 / 39916800.0))))));
    exact float half_turns = turns * 0.5;
    return half_turns == floor(half_turns) ? result : -result;
}

// The angle of (x, y) in [-pi, pi] radians, to within 6e-7; 0 at the origin.
float angle(float y, float x) {
    const float pi = 3.14159265;
    bool steep = abs(y) > abs(x);
    float high = steep ? abs(y) : abs(x), low = steep ? abs(x) : abs(y);
    float q = high > 0.0 ? low / high : 0.0;
    bool first = q > 0.198912367, second = q > 0.668178638;
    float t = second ? 1.0 : first ? 0.414213562 : 0.0;
    float near = second ? pi / 4.0 : first ? pi / 8.0 : 0.0;
    exact float r = (q - t) / (1.0 + q * t);
    exact float z = r * r;
    exact float result = near + (r + r * (z * (-1.0 / 3.0 + z * (1.0 / 5.0 + z * (-1.0 / 7.0 + z * (1.0 / 9.0))))));
    if (steep) result = pi / 2.0 - result;
    if (x < 0.0) result = pi - result;
    return floatBitsToUint(y) >> 31 != 0u ? -result : result;
}

// log2(x) of a normal number x > 0, to within 2e-7 + 2^-24 |log2(x)|.
float binary_log(float x) {
    uint bits = floatBitsToUint(x);
    exact float exponent = float(int(bits >> 23) - 127);
    exact float m = uintBitsToFloat((bits & 0x7fffffu) | 0x3f800000u);
    if (m > 1.41421356) {
        m = m * 0.5;
        exponent = exponent + 1.0;
    }
    exact float s = (m - 1.0) / (m + 1.0);
    exact float z = s * s;
    exact float result = exponent
        + (s * 2.88539008) * (1.0 + z * (1.0 / 3.0 + z * (1.0 / 5.0 + z * (1.0 / 7.0 + z * (1.0 / 9.0)))));
    return result;
}

// 2^x to a relative error of 2e-7; 0 below -126, infinite from 127.5 on.
float binary_power(float x) {
    bool low = x < -126.0, high = x >= 127.5;
    float y = low || high ? 0.0 : x;
    exact float whole = roundEven(y);
    exact float r = (y - whole) * 0.693147181;
    exact float result = uintBitsToFloat(uint(int(whole) + 127) << 23)
        * (1.0 + r * (1.0 + r * (1.0 / 2.0 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0
        + r * (1.0 / 720.0 + r * (1.0 / 5040.0))))))));
    return high ? uintBitsToFloat(0x7f800000u) : low ? 0.0 : result;
}

const float least_normal = 1.17549435e-38;
const float quarter_turn = 1.5707963267948966;

#endif

// cos(x), x in radians: the sine of x + pi / 2.
real cosine(real x) {
    exact real ahead = x + quarter_turn;
    return sine(ahead);
}

// x^e for an e >= 0 that is not whole; a negative x counts as 0.
real power(real x, real e) {
    exact real result = binary_power(e * binary_log(x >= least_normal ? x : real(1.0)));
    return x >= least_normal ? result : real(0.0);
}

// x^e by repeated squaring.
real whole_power(real x, uint e) {
    exact real result = real(1.0);
    exact real square = x;
    for (uint bit = e; bit > 0u; bit >>= 1) {
        if ((bit & 1u) != 0u) result = result * square;
        square = square * square;
    }
    return result;
}
