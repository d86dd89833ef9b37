// The colour map's mean from a summed-area table (Hart et al. 1999, section 3.3.2):
// procedural/color/sums.h in its sequence of operations. This part must follow color/index.glsl and
// color/table.glsl.
uniform real sums_first;  // entry up to which the table's first element is the sum
uniform int sums_count;
uniform real3 sums_ends[2];  // entries before the table and behind it, where the map is clamped
const real map_entries = real(1024.0);

real3 stored_sum(real x) {
    exact real place = min(max(x - sums_first, real(0.0)), real(sums_count - 1));
    int cell = min(int(place), sums_count - 2);
    real3 low = table_color(cell), high = table_color(cell + 1);
    exact real3 sum = low + (place - real(cell)) * (high - low);
    return sum;
}

real3 sum_to(real x) {
    bool inside = x >= sums_first && x <= sums_first + real(sums_count - 1);
#if COLOR_REPEATS
    real periods = inside ? real(0.0) : floor(x / map_entries);
    exact real rest = x - periods * map_entries;
    exact real3 sum = stored_sum(rest) + periods * stored_sum(map_entries);
    return sum;
#else
    exact real before = x - sums_first, after = before - real(sums_count - 1);
    exact real3 sum = stored_sum(x) + (x < real(0.0) ? before * sums_ends[0] : after * sums_ends[1]);
    return inside ? stored_sum(x) : sum;
#endif
}

real3 table_mean(real f, real width) {
    bool finite_width = !(isnan(width) || isinf(width)), finite = !(isnan(f) || isinf(f));
    exact real entries = width * map_entries;
    real wide = finite_width && entries > real(1.0) ? entries : real(1.0);
    real middle = finite ? f : real(0.0);
#if COLOR_REPEATS
    exact real part = middle - floor(middle);
    middle = part;
#endif
    exact real place = map_entries * middle;
    exact real low = place - real(0.5) * wide, high = place + real(0.5) * wide;
    exact real3 mean = (sum_to(high) - sum_to(low)) / wide;
    return mean;
}
