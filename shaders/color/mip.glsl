// The colour map's mean from tables of halved resolutions (Hart et al. 1999, section 3.3.1):
// procedural/color/mip.h in its sequence of operations. This part must follow color/index.glsl,
// color/table.glsl and numbers/elementary.glsl. The first table has 2^COLOR_MIP_FINEST entries;
// each further table has half as many, down to one.
real3 at_level(int level, real index) {
    int count = (1 << COLOR_MIP_FINEST) >> level, first = (2 << COLOR_MIP_FINEST) - 2 * count;
    exact real x = index * real(count) - real(0.5);
    real cell = floor(x);
    int i = int(cell);
#if COLOR_REPEATS
    int j = (i + 1) % count;
    i = (i + count) % count;
#else
    int j = min(i + 1, count - 1);
    i = max(i, 0);
#endif
    real3 low = table_color(first + i), high = table_color(first + j);
    exact real3 color = low + (x - cell) * (high - low);
    return color;
}

real3 table_mean(real f, real width) {
    real index = color_index(f);
    exact real entries = width * real(1 << COLOR_MIP_FINEST);
    real level = binary_log(entries < real(1.0) ? real(1.0) : entries);
    bool last = !(level < real(COLOR_MIP_FINEST));
    int i = last ? COLOR_MIP_FINEST - 1 : int(level);
    real3 fine = at_level(i, index), coarse = at_level(i + 1, index);
    exact real3 mean = fine + (level - real(i)) * (coarse - fine);
    return last ? table_color((2 << COLOR_MIP_FINEST) - 2) : mean;
}
