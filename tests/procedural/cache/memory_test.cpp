// Memory that is freed holds nothing, and what is dragged is known after its second change.
#include "procedural/cache/memory.h"

#include <gtest/gtest.h>

#include "procedural/cache/synthesis.h"
#include "procedural/fill/synthesize.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

Texture one_term(double frequency) {
    Texture texture;
    texture.noise.resize(1);
    texture.noise[0].frequency = Vec3d(frequency);
    texture.colors.stops = {{0.0, {1, 2, 3}}, {1.0, {250, 240, 230}}};
    return texture;
}

TEST(CacheMemory, HoldsNothingInArraysThatItFreed) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    CacheMemory memory(solid, 8 * 40 * 48);  // room for f, none for its slopes
    const FieldKey key(one_term(2.0), {});
    ASSERT_TRUE(memory.allot_field(false));
    EXPECT_FALSE(memory.field.holds(key));
    memory.field.set_key(key);
    EXPECT_TRUE(memory.field.holds(key));
    EXPECT_FALSE(memory.allot_field(true));
    EXPECT_FALSE(memory.field.holds(key));
    EXPECT_EQ(memory.bytes(), 0u);
}

TEST(CacheMemory, IsEvaluatedAnewAfterAFilterThatItHasNoRoomFor) {
    const SolidAtlas solid = SyntheticAtlas{40, 11, 10.0, 0.02, true}.make(1);
    CachedSynthesis cached(solid, {}, 8 * 40 * 48);
    const Texture texture = one_term(2.0);
    Image<Rgb8> image;
    for (const FilterKind kind : {FilterKind::none, FilterKind::exact, FilterKind::none}) {
        const Filter filter{kind, 16, false};
        cached.synthesize(texture, 1, image, filter);
        EXPECT_EQ(image, synthesize_model<Rgb8>(solid, texture, {}, 1, filter));
        EXPECT_FALSE(cached.work().field_cached);
    }
}

TEST(EditTracker, CallsDraggedWhatChangesInTwoFieldsRunning) {
    EditTracker history;
    const auto record = [&](double frequency) {
        const Texture texture = one_term(frequency);
        history.record(FieldSampler(texture, false).noise_keys(), FieldKey(texture, {}));
        return history.octave_dragged(0);
    };
    EXPECT_FALSE(record(1.0));
    EXPECT_FALSE(record(2.0));
    EXPECT_TRUE(record(3.0));
    EXPECT_TRUE(history.field_dragged());
    EXPECT_FALSE(history.quadric_dragged());
    EXPECT_FALSE(record(3.0));
    EXPECT_FALSE(record(4.0));
    EXPECT_FALSE(history.field_dragged());
}

}  // namespace
}  // namespace burl
