// An image over a footprint, between its levels or by an elliptically weighted average, with its
// derivatives by s and t, as in procedural/color/mip_image.cpp. This part must follow
// graph/dual_map.glsl.

struct ImageSample {
    real3 color, by_s, by_t;
};

ImageSample flat_sample(real3 color) {
    return ImageSample(color, real3(0.0), real3(0.0));
}

// The texel at the origin, which is a level's only one in the coarsest level.
ImageSample first_texel(sampler2D image, int level, int wrap) {
    return flat_sample(image_texel(image, level, real(0.0), real(0.0), wrap));
}

ImageSample bilinear_sample(sampler2D image, int level, real s, real t, int wrap) {
    if (!(abs(s) < farthest_image && abs(t) < farthest_image))
        return first_texel(image, level, wrap);
    real2 size = real2(level_size(image, level));
    exact real x = s * size.x - real(0.5), y = t * size.y - real(0.5);
    real i = floor(x), j = floor(y);
    exact real u = x - i, v = y - j, left = real(1.0) - u, top = real(1.0) - v;
    real3 a = image_texel(image, level, i, j, wrap),
          b = image_texel(image, level, i + real(1.0), j, wrap),
          c = image_texel(image, level, i, j + real(1.0), wrap),
          d = image_texel(image, level, i + real(1.0), j + real(1.0), wrap);
    exact real3 low = left * a + u * b, high = left * c + u * d;
    exact real3 color = top * low + v * high, by_s = size.x * (top * (b - a) + v * (d - c)),
                by_t = size.y * (high - low);
    return ImageSample(color, by_s, by_t);
}

// The blend (1 - w) a + w b.
ImageSample blended(ImageSample a, ImageSample b, real w) {
    exact real rest = real(1.0) - w;
    exact real3 color = rest * a.color + w * b.color, by_s = rest * a.by_s + w * b.by_s,
                by_t = rest * a.by_t + w * b.by_t;
    return ImageSample(color, by_s, by_t);
}

ImageSample trilinear_sample(sampler2D image, int levels, real s, real t, real width, int wrap) {
    real last = real(levels - 1);
    exact real level = width > real(0.0) ? last + binary_log(width) : real(-1.0);
    if (!(level > real(0.0))) return bilinear_sample(image, 0, s, t, wrap);
    if (level >= last) return first_texel(image, levels - 1, wrap);
    int below = int(floor(level));
    exact real above = level - floor(level);
    return blended(bilinear_sample(image, below, s, t, wrap),
                   bilinear_sample(image, below + 1, s, t, wrap), above);
}

ImageSample ellipse_sample(sampler2D image, int level, real s, real t, real2 first, real2 second,
                           int wrap) {
    if (!(abs(s) < farthest_image && abs(t) < farthest_image))
        return first_texel(image, level, wrap);
    real2 size = real2(level_size(image, level));
    exact real x = s * size.x - real(0.5), y = t * size.y - real(0.5);
    exact real2 p = first * size, q = second * size;
    // r^2 = a dx^2 + b dx dy + c dy^2, which is 1 on the ellipse of the two steps, one texel wider.
    exact real a = p.y * p.y + q.y * q.y + real(1.0), b = real(-2.0) * (p.x * p.y + q.x * q.y),
               c = p.x * p.x + q.x * q.x + real(1.0);
    exact real scale = real(1.0) / (a * c - real(0.25) * b * b);
    a = a * scale;
    b = b * scale;
    c = c * scale;
    exact real determinant = real(4.0) * a * c - b * b;
    exact real reach_x = real(2.0) * nearest_root(c / determinant),
               reach_y = real(2.0) * nearest_root(a / determinant);
    exact real3 color = real3(0.0), by_s = real3(0.0), by_t = real3(0.0);
    exact real weights = real(0.0), weights_by_x = real(0.0), weights_by_y = real(0.0);
    real end = binary_power(gaussian_falloff);
    for (real j = ceil(y - reach_y); j <= y + reach_y; j += real(1.0))
        for (real i = ceil(x - reach_x); i <= x + reach_x; i += real(1.0)) {
            exact real dx = i - x, dy = j - y;
            exact real r2 = a * dx * dx + b * dx * dy + c * dy * dy;
            if (r2 >= real(1.0)) continue;
            exact real gauss = binary_power(gaussian_falloff * r2), weight = gauss - end;
            exact real by_x = real(2.0) * gauss * (real(2.0) * a * dx + b * dy),
                       by_y = real(2.0) * gauss * (b * dx + real(2.0) * c * dy);
            real3 texel = image_texel(image, level, i, j, wrap);
            color = color + weight * texel;
            by_s = by_s + by_x * texel;
            by_t = by_t + by_y * texel;
            weights = weights + weight;
            weights_by_x = weights_by_x + by_x;
            weights_by_y = weights_by_y + by_y;
        }
    exact real3 mean = color / weights;
    exact real3 mean_by_s = size.x * (by_s - weights_by_x * mean) / weights,
                mean_by_t = size.y * (by_t - weights_by_y * mean) / weights;
    return ImageSample(mean, mean_by_s, mean_by_t);
}

ImageSample ewa_sample(sampler2D image, int levels, real s, real t, real2 first, real2 second,
                       real anisotropy, int wrap) {
    exact real square1 = first.x * first.x + first.y * first.y,
               square2 = second.x * second.x + second.y * second.y;
    real2 wide = square1 < square2 ? second : first, narrow = square1 < square2 ? first : second;
    real longer = nearest_root(max(square1, square2)), shorter = nearest_root(min(square1, square2));
    if (!(longer < farthest_image)) return first_texel(image, levels - 1, wrap);
    if (shorter * anisotropy < longer && shorter > real(0.0)) {
        exact real2 widened = narrow * (longer / (shorter * anisotropy));
        narrow = widened;
        shorter = longer / anisotropy;
    }
    if (!(shorter > real(0.0)))
        return trilinear_sample(image, levels, s, t, longer / anisotropy, wrap);
    real last = real(levels - 1);
    exact real level = max(real(0.0), last + binary_log(shorter));
    if (level >= last) return first_texel(image, levels - 1, wrap);
    int below = int(floor(level));
    exact real above = level - floor(level);
    return blended(ellipse_sample(image, below, s, t, wide, narrow, wrap),
                   ellipse_sample(image, below + 1, s, t, wide, narrow, wrap), above);
}

// The image's colour with its gradient, from the coordinates' gradients by the chain rule.
DualColor dual_image(ImageSample at, real4 s, real4 t) {
    exact real3 r = at.by_s.r * s.yzw + at.by_t.r * t.yzw,
                g = at.by_s.g * s.yzw + at.by_t.g * t.yzw,
                b = at.by_s.b * s.yzw + at.by_t.b * t.yzw;
    return DualColor(real4(at.color.r, r), real4(at.color.g, g), real4(at.color.b, b));
}
// The width of a trilinear lookup: twice the longest component of the two steps.
real trilinear_width(real2 u, real2 v) {
    return real(2.0) * max(max(abs(u.x), abs(u.y)), max(abs(v.x), abs(v.y)));
}
