// The worker of the editor: the last request is always served, and nothing older finishes after it.
#include "app/editor/jobs/worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <utility>
#include <vector>

namespace burl {
namespace {

Recipe worker_scaled(double scale) {
    Recipe recipe;
    recipe.solid.scale = scale;
    return recipe;
}

TEST(EditWorker, DoesWhatItIsAskedAndWakes) {
    std::vector<std::pair<double, bool>> made;
    std::atomic<int> woken = 0;
    EditWorker worker(
        [&](const WorkerRequest& request, const std::stop_token&) {
            made.emplace_back(request.recipe.solid.scale, request.moving);
        },
        [&] { ++woken; });
    EXPECT_TRUE(worker.idle());
    worker.request({worker_scaled(2), true});
    worker.wait();
    worker.request({worker_scaled(3), false});
    worker.wait();
    EXPECT_EQ(made, (std::vector<std::pair<double, bool>>{{2, true}, {3, false}}));
    EXPECT_GE(woken, 1);
}

TEST(EditWorker, ANewRequestStopsTheOldOne) {
    std::atomic<bool> started = false;
    std::vector<double> finished;
    EditWorker worker(
        [&](const WorkerRequest& request, const std::stop_token& stop) {
            if (request.recipe.solid.scale == 1) {
                started = true;
                while (!stop.stop_requested())
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                return;
            }
            finished.push_back(request.recipe.solid.scale);
        },
        [] {});
    worker.request({worker_scaled(1), false});
    while (!started) std::this_thread::yield();
    EXPECT_FALSE(worker.idle());
    worker.request({worker_scaled(2), false});
    worker.wait();
    EXPECT_EQ(finished, std::vector<double>{2});
}

TEST(EditWorker, ASlidersPictureComesBeforeTheNext) {
    std::atomic<bool> started = false, go_on = false;
    std::vector<std::pair<double, bool>> made;
    EditWorker worker(
        [&](const WorkerRequest& request, const std::stop_token& stop) {
            started = true;
            while (!go_on) std::this_thread::yield();
            made.emplace_back(request.recipe.solid.scale, stop.stop_requested());
        },
        [] {});
    worker.request({worker_scaled(1), true});
    while (!started) std::this_thread::yield();
    worker.request({worker_scaled(2), true});  // is dropped
    worker.request({worker_scaled(3), true});
    go_on = true;
    worker.wait();
    EXPECT_EQ(made, (std::vector<std::pair<double, bool>>{{1, false}, {3, false}}));
}

TEST(EditWorker, EndsWhileAtWork) {
    std::atomic<bool> started = false, stopped = false;
    {
        EditWorker worker(
            [&](const WorkerRequest&, const std::stop_token& stop) {
                started = true;
                while (!stop.stop_requested()) std::this_thread::yield();
                stopped = true;
            },
            [] {});
        worker.request({worker_scaled(1), false});
        while (!started) std::this_thread::yield();
    }
    EXPECT_TRUE(stopped);
}

TEST(EditWorker, TellsAProblemOnceAndGoesOn) {
    int made = 0;
    EditWorker worker(
        [&](const WorkerRequest& request, const std::stop_token&) {
            if (request.recipe.solid.scale == 1) throw std::runtime_error("no such noise");
            ++made;
        },
        [] {});
    worker.request({worker_scaled(1), false});
    worker.wait();
    EXPECT_EQ(worker.take_problem(), "no such noise");
    EXPECT_FALSE(worker.take_problem());
    worker.request({worker_scaled(2), false});
    worker.wait();
    EXPECT_EQ(made, 1);
}

}  // namespace
}  // namespace burl
