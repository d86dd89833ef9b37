// Estimates of the time left, and what people and programs are told.
#include "app/base/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "atlas/base/json.h"

namespace burl {
namespace {

using Reading = TaskMeter::Reading;

const std::vector<ExpectedTask> three{{"texture", 10.0}, {"normals", 20.0}, {"writing", 5.0}};

Reading at(const char* task, std::uint64_t done, double seconds) {
    Reading reading;
    reading.task = task, reading.total = 1000, reading.done = done;
    reading.seconds = reading.round_seconds = seconds;
    return reading;
}

TEST(TimeLeft, IsAsExpectedWhereTheTasksPaceIs) {
    const TimeLeft left = time_left(at("texture", 250, 2.5), three);
    EXPECT_NEAR(*left.seconds, 7.5 + 20.0 + 5.0, 1e-9);
    EXPECT_NEAR(left.share, 2.5 / 35.0, 1e-9);
    EXPECT_NEAR(*time_left(at("texture", 0, 0.0), three).seconds, 35.0, 1e-9);
    EXPECT_NEAR(*time_left(at("writing", 500, 2.5), three).seconds, 2.5, 1e-9);
}

TEST(TimeLeft, OfLaterTasksFollowsThePaceOfWhatIsDone) {
    // Four times as slow as expected: the bake, on a busy machine, takes 140 s.
    const double early = *time_left(at("texture", 200, 8.0), three).seconds;
    const double late = *time_left(at("texture", 900, 36.0), three).seconds;
    EXPECT_GT(early, 35.0) << "longer than expected";
    EXPECT_LT(early, 132.0);
    EXPECT_NEAR(late, 104.0, 0.4 * 104.0);
    Reading reading = at("normals", 0, 0.0);
    reading.past = {{"texture", 40.0}};
    EXPECT_NEAR(*time_left(reading, three).seconds, 25.0 * 47.0 / 17.0, 1e-9);
    reading.done = 900, reading.seconds = 72.0;
    EXPECT_NEAR(*time_left(reading, three).seconds, 8.0 + 20.0, 4.0);
    reading.past = {{"texture", 40.0}, {"normals", 80.0}}, reading.task = "writing";
    reading.done = 950, reading.seconds = 19.0;
    EXPECT_NEAR(*time_left(reading, three).seconds, 1.0, 0.01);
}

TEST(TimeLeft, OfATaskThatCountsNothingIsWhatWasExpected) {
    Reading reading = at("writing", 0, 2.0);
    reading.total = 0;
    EXPECT_NEAR(*time_left(reading, three).seconds, 3.0, 1e-9);
    reading.seconds = 60.0;
    EXPECT_EQ(*time_left(reading, three).seconds, 0.0) << "longer than expected";
}

TEST(TimeLeft, OfATaskThatComesTwiceKnowsWhichItIs) {
    const std::vector<ExpectedTask> twice{
        {"texture", 10.0}, {"normals", 20.0}, {"levels", 3.0}, {"normals", 20.0}};
    EXPECT_NEAR(*time_left(at("normals", 500, 10.0), twice).seconds, 10.0 + 23.0, 1e-9);
    Reading reading = at("normals", 500, 10.0);
    reading.past = {{"texture", 10.0}, {"normals", 20.0}};
    EXPECT_NEAR(*time_left(reading, twice).seconds, 10.0, 1e-9);
    reading.past.push_back({"normals", 20.0});
    EXPECT_NEAR(*time_left(reading, twice).seconds, 10.0, 1e-9) << "more often than expected";
}

TEST(TimeLeft, IsUnknownBeforeAPaceIsKnown) {
    const std::vector<ExpectedTask> one{{"texture"}};
    EXPECT_FALSE(time_left(at("texture", 0, 1.0), one).seconds);
    EXPECT_FALSE(time_left(at("texture", 900, 0.01), one).seconds);
    EXPECT_DOUBLE_EQ(*time_left(at("texture", 250, 10.0), one).seconds, 30.0);
    EXPECT_FALSE(time_left(at("reading", 500, 10.0), three).seconds);
    EXPECT_EQ(time_left(at("reading", 500, 10.0), three).share, 0.0);
}

TEST(TimeLeft, OfRoundsIsThatOfTheRoundsBefore) {
    Reading reading = at("texture", 500, 3.0);
    reading.rounds = 10;
    const std::vector<ExpectedTask> one{{"texture"}};
    EXPECT_DOUBLE_EQ(*time_left(reading, one).seconds, 3.0 + 9.0 * 6.0);
    reading.round = 4, reading.earlier_seconds = 40.0;
    const TimeLeft left = time_left(reading, one);
    EXPECT_DOUBLE_EQ(*left.seconds, 3.0 + 5.0 * 10.0);
    EXPECT_DOUBLE_EQ(left.share, 43.0 / (43.0 + 53.0));
    reading.done = 0;
    EXPECT_DOUBLE_EQ(*time_left(reading, one).seconds, 7.0 + 5.0 * 10.0);
}

TEST(TaskMeter, KnowsTaskShareAndWhatIsOver) {
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
    EXPECT_TRUE(meter.read().past.empty()) << "the layout did not count";
    meter.begin("writing");
    ASSERT_EQ(meter.read().past.size(), 1u);
    EXPECT_EQ(meter.read().past[0].task, "texture");
    EXPECT_GT(meter.read().past[0].seconds, 0.0);
    EXPECT_EQ(meter.read().done, 0u);
    meter.begin_round(1, 2);
    EXPECT_TRUE(meter.read().past.empty());
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
