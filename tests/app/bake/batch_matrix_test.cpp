// Matrices of meshes, recipes and sizes, and the job queue, by their promises.
#include <atomic>
#include <fstream>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/bake/batch_manifest.h"
#include "app/bake/batch_matrix.h"
#include "app/bake/batch_schedule.h"
#include "app/options/input_limits.h"
#include "atlas/base/error.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

MatrixKeys keys_in(const std::string& folder) {
    return {[](const std::string& key) { return key != "set"; },
            [](const std::string& key, const std::string& value) {
                return key == "mesh" || value.find('/') != std::string::npos;
            },
            folder};
}

std::vector<Json> combinations(const Json& entry, const MatrixKeys& keys) {
    const Combinations all(entry, keys);
    std::vector<Json> bakes;
    for (std::size_t i = 0; i < all.count(); ++i) bakes.push_back(all[i]);
    return bakes;
}

std::vector<std::string> outputs_of(const std::vector<Json>& bakes) {
    std::vector<std::string> outputs;
    for (const Json& bake : bakes) outputs.push_back(bake["output"]);
    return outputs;
}

TEST(BatchMatrix, EveryCombinationInOrder) {
    const Json entry = Json::parse(R"({"mesh": ["x/a.obj", "b.ply"], "recipe": ["oak", "my/r.json",
        "w.mtlx#pine"], "size": [64, 128], "set": ["p=1", "q=2"],
        "output": "o/{mesh}_{recipe}_{size}.png"})");
    const std::vector<Json> bakes = combinations(entry, keys_in("."));
    EXPECT_THAT(outputs_of(bakes),
                testing::ElementsAre("o/a_oak_64.png", "o/a_oak_128.png", "o/a_r_64.png",
                                     "o/a_r_128.png", "o/a_pine_64.png", "o/a_pine_128.png",
                                     "o/b_oak_64.png", "o/b_oak_128.png", "o/b_r_64.png",
                                     "o/b_r_128.png", "o/b_pine_64.png", "o/b_pine_128.png"));
    for (const Json& bake : bakes) EXPECT_EQ(bake["set"], entry["set"]);
    EXPECT_EQ(bakes[2]["recipe"], "my/r.json");
}

TEST(BatchMatrix, PatternsAreTheFilesThatMatch) {
    const ScratchFolder folder;
    for (const char* name : {"b.obj", "a.obj", "c.ply", "[b]1.obj"}) std::ofstream(folder / name);
    const Json entry =
        Json::parse(R"({"mesh": ["*.ply", "[b]*.obj", "?.obj"], "output": "{mesh}.png"})");
    const std::vector<Json> bakes = combinations(entry, keys_in(folder.path()));
    EXPECT_THAT(outputs_of(bakes), testing::ElementsAre("c.png", "[b]1.png", "a.png", "b.png"));
    EXPECT_EQ(bakes[0]["mesh"], folder / "c.ply");
}

TEST(BatchMatrix, WhatCannotBeIsRefused) {
    const auto refused = [](const char* entry) {
        EXPECT_THROW(combinations(Json::parse(entry), keys_in("/nowhere")), Error) << entry;
    };
    refused(R"({"mesh": "*.obj", "output": "a.png"})");
    refused(R"({"mesh": [], "output": "a.png"})");
    refused(R"({"mesh": "a.obj", "output": "{material}.png"})");
    refused(R"({"mesh": "a.obj", "set": ["a=1"], "output": "{set}.png"})");
    refused(R"({"mesh": "in/...obj", "output": "out/{mesh}/a.png"})");
    Json huge;  // 256^8 = 2^64 bakes, which is 0 in 64 bits
    for (const char* key :
         {"mesh", "recipe", "size", "atlas", "levels", "crease", "kernel", "pose"})
        huge[key] = Json(std::vector<int>(256, 1));
    refused(huge.dump().c_str());
}

TEST(BatchMatrix, WhatIsNoMatrixIsItself) {
    for (const char* text : {R"({"mesh": "a.obj", "set": ["a=1", "b=2"], "strict": true})", "{}",
                             R"({"output": "a{.png"})"}) {
        const Json entry = Json::parse(text);
        EXPECT_THAT(combinations(entry, keys_in(".")), testing::ElementsAre(entry)) << text;
    }
}

/// Watches what jobs hold together.
class Holding {
  public:
    void add(std::uint64_t bytes) {
        const std::scoped_lock lock(mutex_);
        held_ += bytes, ++jobs_;
        most_bytes = std::max(most_bytes, held_);
        most_jobs = std::max(most_jobs, jobs_);
        if (held_ > 100 && jobs_ > 1) too_much = true;
    }
    void remove(std::uint64_t bytes) {
        const std::scoped_lock lock(mutex_);
        held_ -= bytes, --jobs_;
    }
    std::uint64_t most_bytes = 0;
    int most_jobs = 0;
    bool too_much = false;

  private:
    std::uint64_t held_ = 0;
    int jobs_ = 0;
    std::mutex mutex_;
};

TEST(BatchMatrix, ShardsAreAllAndNothingTwice) {
    for (const std::size_t count : {0u, 1u, 12u, 1000u, 999u})
        for (const std::size_t parts : {1u, 3u, 10u, 100u, 1000u}) {
            std::size_t next = 0;
            for (std::size_t part = 0; part < parts; ++part) {
                const BatchShard shard{part, parts};
                EXPECT_EQ(shard.first(count), next);
                next = shard.last(count);
                EXPECT_LE(next - shard.first(count), count / parts + 1);
            }
            EXPECT_EQ(next, count);
        }
    EXPECT_EQ(batch_shard("3/7").part, 2u);
    EXPECT_EQ(batch_shard("").parts, 1u);
    for (const char* text : {"0/3", "4/3", "1", "1/", "/2", "1/2/3", "a/b", "-1/2"})
        EXPECT_THROW(batch_shard(text), Error) << text;
}

TEST(JobQueue, RunsAllOnceWithinTheBudget) {
    Holding holding;
    std::vector<std::atomic<int>> runs(60);
    std::vector<QueuedJob> jobs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::uint64_t bytes = i == 20 ? 500 : 10 + i * 7 % 50;
        jobs.push_back({bytes, [&holding, &runs, i, bytes] {
                            holding.add(bytes);
                            std::this_thread::sleep_for(std::chrono::milliseconds(2));
                            ++runs[i];
                            holding.remove(bytes);
                        }});
    }
    run_jobs(jobs, 4, 100);
    for (const auto& count : runs) EXPECT_EQ(count, 1);
    EXPECT_FALSE(holding.too_much);
    EXPECT_EQ(holding.most_bytes, 500u);
    EXPECT_GT(holding.most_jobs, 1);
}

TEST(JobQueue, OneWorkerKeepsTheOrder) {
    std::vector<int> order;
    std::vector<QueuedJob> jobs;
    for (int i = 0; i < 9; ++i)
        jobs.push_back({std::uint64_t(i), [&order, i] { order.push_back(i); }});
    run_jobs(jobs, 1, 3);
    EXPECT_THAT(order, testing::ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(JobQueue, SizesOfMemory) {
    EXPECT_EQ(memory_size("--memory", "4G"), std::uint64_t(4) << 30U);
    EXPECT_EQ(memory_size("--memory", "1.5M"), 3u << 19U);
    EXPECT_EQ(memory_size("--memory", "512"), 512u << 20U);
    EXPECT_EQ(memory_size("--memory", "64K"), 65536u);
    for (const char* text : {"", "G", "-1G", "4T", "nan", "4 G", "0"})
        EXPECT_THROW(memory_size("--memory", text), Error) << text;
}

}  // namespace
}  // namespace burl
