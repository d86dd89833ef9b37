// Estimates of the time left, and what people and programs are told.
#include "app/base/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace burl {
namespace {

using Reading = TaskMeter::Reading;

const std::vector<ExpectedTask> three{
    {"texture", std::nullopt}, {"normals", 1.0, 2.0}, {"writing", 5.0}};

Reading at(const char* task, std::uint64_t done, double seconds) {
    Reading reading;
    reading.task = task, reading.total = 1000, reading.done = done;
    reading.seconds = reading.round_seconds = seconds;
    return reading;
}

TEST(TimeLeft, IsThatOfTheTasksPaceAndOfWhatFollows) {
    const TimeLeft left = time_left(at("texture", 250, 10.0), three);
    EXPECT_DOUBLE_EQ(*left.seconds, 30.0 + (1.0 + 2.0 * 40.0) + 5.0);
    EXPECT_DOUBLE_EQ(left.share, 10.0 / (10.0 + *left.seconds));
}

TEST(TimeLeft, IsUnknownBeforeAPaceIsKnown) {
    EXPECT_FALSE(time_left(at("texture", 0, 1.0), three).seconds);
    EXPECT_FALSE(time_left(at("texture", 900, 0.01), three).seconds);
    EXPECT_FALSE(time_left(at("reading", 500, 10.0), three).seconds);
    EXPECT_EQ(time_left(at("reading", 500, 10.0), three).share, 0.0);
}

TEST(TimeLeft, OfALaterTaskKnowsHowLongTheTextureTook) {
    Reading reading = at("normals", 0, 4.0);
    reading.texel_seconds = 10.0;
    EXPECT_DOUBLE_EQ(*time_left(reading, three).seconds, (1.0 + 20.0 - 4.0) + 5.0);
    reading.seconds = 40.0;
    EXPECT_DOUBLE_EQ(*time_left(reading, three).seconds, 5.0) << "longer than expected";
    EXPECT_DOUBLE_EQ(*time_left(at("writing", 500, 8.0), three).seconds, 8.0);
    EXPECT_DOUBLE_EQ(*time_left(at("writing", 25, 1.0), three).seconds, 0.5 * 39.0 + 0.5 * 4.0)
        << "half by the pace, half as expected";
}

TEST(TimeLeft, OfRoundsIsThatOfTheRoundsBefore) {
    Reading reading = at("texture", 500, 3.0);
    reading.rounds = 10;
    const std::vector<ExpectedTask> one{{"texture", std::nullopt}};
    EXPECT_DOUBLE_EQ(*time_left(reading, one).seconds, 3.0 + 9.0 * 6.0);
    reading.round = 4, reading.earlier_seconds = 40.0;
    const TimeLeft left = time_left(reading, one);
    EXPECT_DOUBLE_EQ(*left.seconds, 3.0 + 5.0 * 10.0);
    EXPECT_DOUBLE_EQ(left.share, 43.0 / (43.0 + 53.0));
    reading.done = 0;
    EXPECT_DOUBLE_EQ(*time_left(reading, one).seconds, 7.0 + 5.0 * 10.0);
}

TEST(TaskMeter, KnowsTaskShareAndTheTimeOfTheTexels) {
    TaskMeter meter;
    meter.begin_round(0, 2);
    meter.begin("layout");
    EXPECT_EQ(meter.read().share(), 0.0);
    meter.begin("texture", 8, true);
    meter.add(2);
    EXPECT_EQ(meter.read().task, "texture");
    EXPECT_DOUBLE_EQ(meter.read().share(), 0.25);
    meter.add(20);
    EXPECT_DOUBLE_EQ(meter.read().share(), 1.0) << "never more";
    EXPECT_EQ(meter.read().texel_seconds, 0.0);
    meter.begin("writing");
    EXPECT_GT(meter.read().texel_seconds, 0.0);
    EXPECT_EQ(meter.read().done, 0u);
    meter.begin_round(1, 2);
    EXPECT_EQ(meter.read().texel_seconds, 0.0);
    EXPECT_EQ(meter.read().round, 1u);
}

TEST(ProgressText, SaysWhatIsKnown) {
    ProgressState state;
    state.task = "reading";
    EXPECT_EQ(progress_text(state), "reading");
    state.item = "a.glb", state.number = 2, state.of = 12, state.round = 1, state.rounds = 3;
    state.share = 0.4299, state.texels_per_second = 12.44e6, state.seconds_left = 131.2;
    EXPECT_EQ(progress_text(state),
              "3 of 12, a.glb: reading, frame 2 of 3, 42 %, 12.4 Mtexel/s, 2 min 12 s left");
}

TEST(ProgressJson, IsOneLineWithNullsForWhatIsUnknown) {
    ProgressState state;
    state.item = "a\n\xff\".glb", state.share = 0.5, state.seconds_left = 3.0;
    const std::string text = progress_json(state);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json.at("share"), 0.5);
    EXPECT_EQ(json.at("seconds_left"), 3.0);
    EXPECT_TRUE(json.at("texels_per_second").is_null());
}

TEST(ProgressMode, IsWhatItIsCalled) {
    EXPECT_EQ(progress_mode("json", true), ProgressMode::json);
    EXPECT_EQ(progress_mode("auto", true), ProgressMode::none);
    EXPECT_EQ(progress_mode("plain", false), ProgressMode::plain);
}

}  // namespace
}  // namespace burl
