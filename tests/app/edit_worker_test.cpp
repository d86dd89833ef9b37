// The worker of the editor: the last recipe always arrives whole, coarse levels first, and nothing
// older than it finishes after it.
#include "app/edit_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <utility>
#include <vector>

namespace burl {
namespace {

Recipe scaled(double scale) {
    Recipe recipe;
    recipe.solid.scale = scale;
    return recipe;
}

TEST(EditWorker, MakesLevelsFromCoarseToFineAndWakes) {
    std::vector<std::pair<double, std::uint32_t>> made;
    std::atomic<int> woken = 0;
    EditWorker worker(
        [&](const Recipe& recipe, std::uint32_t level, const std::stop_token&) {
            made.emplace_back(recipe.solid.scale, level);
            return true;
        },
        [&] { ++woken; });
    EXPECT_TRUE(worker.idle());
    worker.request({scaled(2), 2, 0});
    worker.wait();
    EXPECT_EQ(made, (std::vector<std::pair<double, std::uint32_t>>{{2, 2}, {2, 1}, {2, 0}}));
    worker.request({scaled(3), 0, 0});
    worker.wait();
    EXPECT_EQ(made.back(), std::make_pair(3.0, 0u));
    EXPECT_GE(woken, 3);
}

TEST(EditWorker, ANewRequestStopsTheOldOne) {
    std::atomic<bool> started = false;
    std::vector<double> finished;
    EditWorker worker(
        [&](const Recipe& recipe, std::uint32_t, const std::stop_token& stop) {
            if (recipe.solid.scale == 1) {
                started = true;
                while (!stop.stop_requested())
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                return false;
            }
            finished.push_back(recipe.solid.scale);
            return true;
        },
        [] {});
    worker.request({scaled(1), 3, 0});
    while (!started) std::this_thread::yield();
    EXPECT_FALSE(worker.idle());
    worker.request({scaled(2), 0, 0});
    worker.wait();
    EXPECT_EQ(finished, std::vector<double>{2});
}

TEST(EditWorker, EndsWhileAtWork) {
    std::atomic<bool> started = false, stopped = false;
    {
        EditWorker worker(
            [&](const Recipe&, std::uint32_t, const std::stop_token& stop) {
                started = true;
                while (!stop.stop_requested()) std::this_thread::yield();
                stopped = true;
                return false;
            },
            [] {});
        worker.request({scaled(1), 0, 0});
        while (!started) std::this_thread::yield();
    }
    EXPECT_TRUE(stopped);
}

TEST(EditWorker, TellsAProblemOnceAndGoesOn) {
    int made = 0;
    EditWorker worker(
        [&](const Recipe& recipe, std::uint32_t, const std::stop_token&) {
            if (recipe.solid.scale == 1) throw std::runtime_error("no such noise");
            ++made;
            return true;
        },
        [] {});
    worker.request({scaled(1), 1, 0});
    worker.wait();
    EXPECT_EQ(worker.take_problem(), "no such noise");
    EXPECT_FALSE(worker.take_problem());
    worker.request({scaled(2), 1, 0});
    worker.wait();
    EXPECT_EQ(made, 2);
}

}  // namespace
}  // namespace burl
