// Whatever is cached, the bytes are those of a synthesis from scratch, and what can be cached is.
#include "procedural/cache/synthesis.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "procedural/fill/synthesize.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

constexpr std::size_t plenty_of_cache = std::size_t(1) << 30;
const Affine3 scaled_twice{2.0 * Mat3d(1.0), Vec3d(0.5, 0.0, -3.0)};

/// Terms of every way octaves are added up: chains that double, ones that do not, and noise without
/// a vectorised kernel.
Texture many_terms() {
    Texture texture;
    texture.quadric.i = 0.5;
    texture.noise.resize(3);
    texture.noise[0].octaves = 4, texture.noise[0].frequency = Vec3d(2.0);
    texture.noise[1].kind = NoiseKind::perlin, texture.noise[1].octaves = 2;
    texture.noise[1].lacunarity = 2.1, texture.noise[1].amplitude = 0.7;
    texture.noise[2].kind = NoiseKind::worley, texture.noise[2].shape = OctaveShape::absolute;
    texture.colors.wrap = Wrap::repeat;
    texture.colors.stops = {{0.0, {244, 239, 230}}, {0.4, {10, 200, 30}}, {1.0, {59, 58, 64}}};
    return texture;
}

template <class Pixel>
Image<Pixel> from_scratch(const SolidAtlas& solid, const Texture& texture, Kernel kernel,
                          const Filter& filter = {}) {
    return synthesize_model<Pixel>(solid, texture, scaled_twice, 1, filter, kernel);
}

/// One thing about the texture that a slider would change.
void edit(Texture& texture, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    if (texture.noise.empty()) texture.noise.resize(1);
    NoiseTerm& term = texture.noise[random() % texture.noise.size()];
    switch (random() % 12) {
        case 0:
            texture.colors.stops[0].color = {std::uint8_t(random()), 7, 99};
            break;
        case 1:
            texture.colors.wrap = random() % 2 ? Wrap::clamp : Wrap::repeat;
            break;
        case 2:
            term.amplitude = random() % 4 ? unit(random) : 0.0;
            break;
        case 3:
            term.gain = 0.5 + 0.4 * unit(random);
            break;
        case 4:
            texture.quadric.a = unit(random);
            break;
        case 5:
            term.frequency.y = 3.0 * unit(random);
            break;
        case 6:
            term.seed = std::uint32_t(random());
            break;
        case 7:
            texture.noise.push_back(term);
            break;
        case 8:
            texture.noise.erase(texture.noise.begin());
            break;
        case 9:
            term.octaves = 1 + std::uint32_t(random() % 5);
            break;
        case 10:
            term.range = random() % 2 ? NoiseRange::unit : NoiseRange::bipolar;
            break;
        default:
            term.fade = random() % 2 ? Fade::linear : Fade::quintic;
            break;
    }
    if (texture.noise.size() > 4) texture.noise.resize(2);
}

/// Now and then another filter, mostly none.
void edit(Filter& filter, std::mt19937& random) {
    if (random() % 3) return;
    constexpr std::array kinds{
        FilterKind::none,  FilterKind::none,      FilterKind::table_mip,  FilterKind::table_sat,
        FilterKind::exact, FilterKind::trapezoid, FilterKind::trapezoid2, FilterKind::supersample};
    filter.kind = kinds[random() % kinds.size()];
    filter.samples = 4;
    filter.band_limit = random() % 4 == 0;
}

template <class Pixel>
void follow_edits(Kernel kernel, std::size_t budget, int edits, bool filters = false) {
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
    for (const std::uint32_t block : {11u, 1030u}) {
        const std::uint32_t size = block > 1000 ? 1030 : 37;
        SolidAtlas solid = SyntheticAtlas{size, block, 10.0, 0.02, true}.make(block);
        if (size > 1000) {  // rows longer than a batch, but only two of them
            for (std::size_t y = 2; y <= size; ++y) solid.row_begin[y] = solid.row_begin[2];
            solid.spans.resize(solid.row_begin[2]);
        }
        std::mt19937 random(std::uint32_t(budget % 1000 + block + std::size_t(kernel)));
        CachedSynthesis cached(solid, scaled_twice, budget, kernel);
        Texture texture = many_terms();
        Filter filter;
        Image<Pixel> image;
        for (int i = 0; i < edits; ++i) {
            cached.synthesize(texture, std::array{1, 2, 7, 0}[std::size_t(i) % 4], image, filter);
            ASSERT_EQ(image, from_scratch<Pixel>(solid, texture, kernel, filter)) << "edit " << i;
            ASSERT_LE(cached.bytes(), budget);
            edit(texture, random);
            if (filters) edit(filter, random);
        }
    }
}

TEST(CachedSynthesis, GivesTheBytesOfASynthesisFromScratchAfterAnyEdit) {
    for (const auto& [name, kernel] : kernel_names) {
        SCOPED_TRACE(name);
        follow_edits<Rgb8>(kernel, plenty_of_cache, 20);
    }
    follow_edits<Rgb16>(Kernel::automatic, plenty_of_cache, 5);
    follow_edits<RgbF>(Kernel::automatic, plenty_of_cache, 5);
}

TEST(CachedSynthesis, GivesTheSameBytesWithEveryFilter) {
    follow_edits<Rgb8>(Kernel::automatic, plenty_of_cache, 40, true);
    follow_edits<Rgb16>(Kernel::automatic, plenty_of_cache, 10, true);
    follow_edits<RgbF>(Kernel::scanline, plenty_of_cache, 10, true);
}

TEST(CachedSynthesis, GivesTheSameBytesWithinAnyBudget) {
    for (const std::size_t bytes : {0, 8, 12, 16, 30, 42})
        follow_edits<Rgb8>(Kernel::automatic, bytes * 37 * 48 + 5, 6, bytes % 4 == 0);
}

/// Slider after slider dragged some way, now and then with a texture that somebody does not wait
/// for.
void follow_drags(std::size_t budget, Kernel kernel) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(2);
    std::mt19937 random(std::uint32_t(budget + std::size_t(kernel)));
    CachedSynthesis cached(solid, scaled_twice, budget, kernel);
    Texture texture = many_terms();
    Image<Rgb8> image;
    for (int drag = 0; drag < 30; ++drag) {
        NoiseTerm& term = texture.noise[random() % texture.noise.size()];
        double* const sliders[] = {&term.phase.x, &term.amplitude, &term.gain, &texture.quadric.b};
        double& slider = *sliders[random() % std::size(sliders)];
        for (auto moves = 1 + random() % 5; moves > 0; --moves) {
            slider *= 0.97, slider += 0.01;
            std::stop_source stop;
            Economy economy;
            economy.stop = stop.get_token();
            if (random() % 5 == 0) stop.request_stop();
            cached.synthesize(texture, 1, image, {}, economy);
            if (stop.stop_requested()) continue;
            ASSERT_EQ(image, from_scratch<Rgb8>(solid, texture, kernel)) << "drag " << drag;
            ASSERT_LE(cached.bytes(), budget);
        }
    }
}

TEST(CachedSynthesis, GivesTheSameBytesWhileSlidersAreDragged) {
    for (const std::size_t bytes : {8, 12, 30, 1000})
        follow_drags(bytes * 40 * 48, Kernel::automatic);
    follow_drags(plenty_of_cache, Kernel::scanline);
}

TEST(CachedSynthesis, EvaluatesNothingThatComesBeforeTheOctavesThatMove) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    CachedSynthesis cached(solid, scaled_twice, 8 * 40 * 48);  // no room for octaves
    Texture texture = many_terms();
    Image<Rgb8> image;
    const auto move = [&](double& slider) {
        slider += 0.1;
        SynthesisWork work;
        Economy economy;
        economy.work = &work;
        cached.synthesize(texture, 1, image, {}, economy);
        EXPECT_EQ(image, from_scratch<Rgb8>(solid, texture, Kernel::automatic));
        EXPECT_EQ(work.octaves, cached.work().octaves_evaluated * work.texels);
        EXPECT_EQ(work.octaves + work.octaves_skipped[unsigned(Skip::kept_terms)], 7 * work.texels);
        return cached.work().octaves_evaluated;
    };
    EXPECT_EQ(move(texture.noise[1].phase.x), 7u);
    EXPECT_EQ(move(texture.noise[1].phase.x), 7u);
    EXPECT_EQ(move(texture.noise[1].phase.x), 7u);  // and caches what comes before
    EXPECT_EQ(move(texture.noise[1].phase.x), 3u);
    EXPECT_EQ(move(texture.noise[2].phase.x), 7u);
    EXPECT_EQ(move(texture.noise[2].phase.x), 7u);
    EXPECT_EQ(move(texture.noise[2].phase.x), 1u);
    EXPECT_LE(cached.bytes(), 8u * 40 * 48);
}

TEST(CachedSynthesis, StartsAnewForAnotherMap) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    CachedSynthesis cached(solid, Affine3{}, plenty_of_cache);
    Image<Rgb8> image;
    for (const Affine3& map : {Affine3{}, scaled_twice, scaled_twice, Affine3{}}) {
        cached.set_map(map);
        cached.synthesize(many_terms(), 1, image);
        EXPECT_EQ(image, synthesize_model<Rgb8>(solid, many_terms(), map, 1));
    }
}

TEST(CachedSynthesis, CachesNoOctaveThatIsDragged) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    CachedSynthesis cached(solid, scaled_twice, plenty_of_cache);
    Texture texture = many_terms();
    Image<Rgb8> image;
    std::vector<std::size_t> bytes;
    const auto next = [&] {
        cached.synthesize(texture, 1, image);
        EXPECT_EQ(image, from_scratch<Rgb8>(solid, texture, Kernel::automatic));
        bytes.push_back(cached.bytes());
        return cached.work().octaves_evaluated;
    };
    EXPECT_EQ(next(), 7u);
    for (int i = 0; i < 3; ++i) {
        texture.noise[2].phase.x += 0.1;
        EXPECT_EQ(next(), 1u) << i;
    }
    EXPECT_EQ(bytes[1], bytes[0]);
    EXPECT_LT(bytes[2], bytes[1]);
    EXPECT_EQ(bytes[3], bytes[2]);
    texture.noise[0].amplitude *= 0.9;
    EXPECT_EQ(next(), 1u);
    texture.noise[0].amplitude *= 0.9;
    EXPECT_EQ(next(), 0u);
    EXPECT_EQ(bytes.back(), bytes[0]);
}

TEST(CachedSynthesis, CachesAFieldAgainThatHasComeToRest) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    CachedSynthesis cached(solid, scaled_twice, plenty_of_cache);
    Texture texture = many_terms();
    Image<Rgb8> image;
    const auto next = [&] {
        cached.synthesize(texture, 1, image);
        EXPECT_EQ(image, from_scratch<Rgb8>(solid, texture, Kernel::automatic));
    };
    const auto move_amplitude = [&] {
        texture.noise[2].amplitude *= 0.9;
        next();
    };
    const auto keeps_field_for_colors = [&] {
        texture.colors.stops[0].color.r ^= 1;
        next();
        EXPECT_EQ(cached.work().octaves_evaluated, 0u);
        return cached.work().field_cached;
    };
    next();
    for (int i = 0; i < 3; ++i) move_amplitude();
    EXPECT_FALSE(keeps_field_for_colors());
    EXPECT_TRUE(keeps_field_for_colors());
    move_amplitude();
    EXPECT_TRUE(keeps_field_for_colors());
    move_amplitude();
    texture.quadric.b += 0.1;
    next();
    EXPECT_TRUE(keeps_field_for_colors());
}

TEST(CachedSynthesis, CountsWhatItDidAndSpared) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    std::uint64_t texels = 0;
    for (const Span& span : solid.spans) texels += span.count;
    CachedSynthesis cached(solid, scaled_twice, plenty_of_cache);
    Texture texture = many_terms();
    Image<Rgb8> image;
    const auto expect = [&](std::uint64_t octaves, std::uint64_t skipped) {
        SynthesisWork work;
        cached.synthesize(texture, 0, image, {}, {{}, &work});
        EXPECT_EQ(work.texels, texels);
        EXPECT_EQ(work.octaves, octaves * texels);
        EXPECT_EQ(work.octaves_skipped[unsigned(Skip::kept_terms)], skipped * texels);
        EXPECT_EQ(work.texels_skipped[unsigned(Skip::unread_texels)], 40 * 40 - texels);
    };
    expect(7, 0);
    texture.noise[1].phase.x = 0.3;
    expect(2, 5);
    texture.colors.stops[0].color = {1, 2, 3};
    expect(0, 7);
}

TEST(CachedSynthesis, CachesWhatItHadWhenItIsStopped) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    CachedSynthesis cached(solid, scaled_twice, plenty_of_cache);
    Texture texture = many_terms();
    Image<Rgb8> image;
    cached.synthesize(texture, 1, image);
    texture.noise[1].phase.x = 0.3;
    std::stop_source stop;
    stop.request_stop();
    cached.synthesize(texture, 1, image, {}, {{}, nullptr, stop.get_token()});
    texture.noise[2].phase.x = 0.3;
    cached.synthesize(texture, 1, image);
    EXPECT_EQ(image, from_scratch<Rgb8>(solid, texture, Kernel::automatic));
    EXPECT_EQ(cached.work().octaves_evaluated, 3u);
    EXPECT_EQ(cached.work().octaves_cached, 4u);
}

/// The work of going from one texture to the other.
CachedSynthesis::Work work_between(const Texture& from, const Texture& to,
                                   std::size_t budget = plenty_of_cache) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    CachedSynthesis cached(solid, scaled_twice, budget);
    Image<Rgb8> image;
    cached.synthesize(from, 1, image);
    EXPECT_FALSE(cached.work().field_cached);
    EXPECT_EQ(cached.work().octaves_cached, 0u);
    cached.synthesize(to, 1, image);
    return cached.work();
}

TEST(CachedSynthesis, EvaluatesOnlyWhatIsNew) {
    const Texture texture = many_terms();
    Texture to = texture;
    to.colors.stops[0].color = {1, 2, 3};
    EXPECT_TRUE(work_between(texture, to).field_cached);

    const auto expect = [&](std::size_t cached, std::size_t evaluated) {
        const CachedSynthesis::Work work = work_between(texture, to);
        EXPECT_FALSE(work.field_cached);
        EXPECT_EQ(work.octaves_cached, cached);
        EXPECT_EQ(work.octaves_evaluated, evaluated);
        to = texture;
    };
    to = texture, to.quadric.b = 0.25;
    expect(7, 0);
    for (NoiseTerm& term : to.noise) term.amplitude *= 0.3;
    expect(7, 0);
    to.noise[1].gain = 0.3;
    expect(7, 0);
    to.noise[1].phase.x = 0.3;
    expect(5, 2);
    to.noise[2].frequency.x = 0.3;
    expect(6, 1);
    to.noise[1].seed = 5;
    expect(5, 2);
    to.noise.erase(to.noise.begin() + 1);
    expect(5, 0);
    to.noise.push_back(texture.noise[1]), to.noise.back().seed = 9;
    expect(7, 2);
    // Amplitudes that no longer halve: the octaves get coordinates of their own.
    to.noise[0].gain = 0.8;
    expect(3, 4);
}

TEST(CachedSynthesis, CachesTheFieldFirstAndThenOctavesWithinTheBudget) {
    const Texture texture = many_terms();
    Texture colors = texture, amplitude = texture;
    colors.colors.wrap = Wrap::clamp;
    amplitude.noise[0].amplitude = 0.25;
    const std::size_t texels = 40 * 48;  // rows of 40 take 48 at most
    EXPECT_FALSE(work_between(texture, colors, 100).field_cached);
    EXPECT_TRUE(work_between(texture, colors, 8 * texels).field_cached);
    EXPECT_EQ(work_between(texture, amplitude, 8 * texels).octaves_cached, 0u);
    const std::size_t cached = work_between(texture, amplitude, 16 * texels).octaves_cached;
    EXPECT_GE(cached, 2u);
    EXPECT_LT(cached, 7u);
}

TEST(CachedSynthesis, StatesTheBytesItTakes) {
    const SolidAtlas solid = SyntheticAtlas{64, 16, 10.0, 0.02, false}.make(1);
    CachedSynthesis cached(solid, scaled_twice, plenty_of_cache);
    EXPECT_EQ(cached.bytes(), 0u);
    Image<Rgb8> image;
    cached.synthesize(many_terms(), 1, image);
    EXPECT_EQ(cached.bytes(), std::size_t(64 * 64 * (8 + 7 * 4 + 8)));
    Texture colors = many_terms();
    colors.colors.stops[0].color = {1, 2, 3};
    cached.synthesize(colors, 1, image);
    EXPECT_EQ(cached.bytes(), std::size_t(64 * 64 * (8 + 7 * 4 + 8 + 4)));
}

TEST(CachedSynthesis, PaintsWhatNobodyOwnsAnew) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    CachedSynthesis cached(solid, scaled_twice, plenty_of_cache);
    Image<Rgb8> image(40, 40, Rgb8{1, 2, 3});
    Texture texture = many_terms();
    for (const std::uint8_t red : {std::uint8_t(9), std::uint8_t(77)}) {
        texture.colors.stops[0].color = {red, 0, 0};
        cached.synthesize(texture, 1, image);
        EXPECT_EQ(image, from_scratch<Rgb8>(solid, texture, Kernel::automatic));
    }
    Image<Rgb8> other(3, 5);
    cached.synthesize(texture, 1, other);
    EXPECT_EQ(other, image);
}

}  // namespace
}  // namespace burl
