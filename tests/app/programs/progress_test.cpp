// What a bake tells of itself while it runs, and what an interrupted one leaves.
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/base/json_text.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

/// A bake that takes a second or more.
std::string long_bake(const std::string& out, const std::string& options, int size = 1024) {
    return fmt::format("bake sample:teapot -o '{}' --recipe hammered --size {} --force {}", out,
                       size, options);
}

std::vector<Json> lines_of_json(const std::string& text) {
    std::vector<Json> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with('{')) lines.push_back(Json::parse(line));
    return lines;
}

TEST(ProgressOfBakes, IsJsonWhoseShareGrows) {
    const Scratch scratch;
    const Outcome made = run_burl(scratch, long_bake(scratch / "a.glb", "--progress json -q"));
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const std::vector<Json> lines = lines_of_json(made.err);
    ASSERT_GE(lines.size(), 3u) << made.err;
    double share = 0.0, seconds = 0.0;
    bool has_pace = false;
    for (const Json& line : lines) {
        EXPECT_GE(line.at("share"), share);
        EXPECT_GE(line.at("seconds"), seconds);
        share = line.at("share"), seconds = line.at("seconds");
        // Of short tasks, no line may come when some of their texels are done.
        if (!line.at("texels_per_second").is_null()) has_pace |= line.at("texels_per_second") > 1e3;
    }
    EXPECT_TRUE(has_pace) << made.err;
    EXPECT_EQ(lines.back().at("task"), "done");
    EXPECT_EQ(lines.back().at("share"), 1.0);
}

TEST(ProgressOfBakes, ChangesNoByte) {
    const Scratch scratch;
    for (const char* mode : {"json", "none"})
        ASSERT_EQ(run_burl(scratch, fmt::format("bake sample:torus -o '{}' --recipe oak --size 256 "
                                                "--levels all -q --progress {}",
                                                scratch / (std::string(mode) + ".png"), mode))
                      .exit_code,
                  0);
    EXPECT_EQ(slurp(scratch / "json.png"), slurp(scratch / "none.png"));
    EXPECT_EQ(slurp(scratch / "json_normal.png"), slurp(scratch / "none_normal.png"));
}

TEST(ProgressOfBakes, NumbersTheBakesOfABatch) {
    const Scratch scratch;
    scratch.write("m.json", R"({"defaults": {"mesh": "sample:torus", "size": 256},
        "bakes": [{"recipe": "oak", "output": "a.png"}, {"recipe": "gold", "output": "b.png"}]})");
    const Outcome made =
        run_burl(scratch, fmt::format("batch '{}' --progress json -q", scratch / "m.json"));
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const std::vector<Json> lines = lines_of_json(made.err);
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines.back().at("of"), 2);
    EXPECT_EQ(lines.back().at("number"), 2);
    EXPECT_THAT(lines.back().at("item").get<std::string>(), HasSubstr("b.png"));
}

TEST(ProgressOfBakes, IsSilentWhereNobodyAsks) {
    const Scratch scratch;
    EXPECT_EQ(run_burl(scratch, long_bake(scratch / "a.png", "--progress none")).err, "");
    EXPECT_EQ(run_burl(scratch, long_bake(scratch / "b.png", "-q")).err, "");
    const Outcome wrong = run_burl(scratch, long_bake(scratch / "c.png", "--progress loud"));
    EXPECT_EQ(wrong.exit_code, 1);
    expect_one_sentence(wrong.err);
}

TEST(ProgressOfBakes, IsOneLineOfATerminal) {
    const Scratch scratch;
    const std::string command =
        fmt::format("'{}/bin/burl' {}", binary_folder(), long_bake(scratch / "a.png", "", 2048));
    const std::string typed = scratch / "typed.txt";
    ASSERT_EQ(
        std::system(
            fmt::format("script -qec \"{}\" /dev/null >'{}' </dev/null", command, typed).c_str()),
        0);
    const std::string text = slurp(typed);
    EXPECT_THAT(text, HasSubstr("deriving normals"));
    EXPECT_THAT(text, HasSubstr("texel/s"));
    EXPECT_THAT(text, HasSubstr(" left"));
    // The last line that was drawn is cleared before the summary comes.
    const std::size_t cleared = text.rfind("\r\x1b[K");
    ASSERT_NE(cleared, std::string::npos);
    EXPECT_THAT(text.substr(cleared + 4), testing::StartsWith(scratch / "a.png"));
}

/// A burl under way, whose stderr is a pipe.
class Running {
  public:
    explicit Running(const std::string& arguments) {
        int ends[2];
        EXPECT_EQ(::pipe(ends), 0);
        child_ = ::fork();
        if (child_ == 0) {
            ::dup2(ends[1], STDERR_FILENO);
            ::close(ends[0]);
            // Shells start what runs beside them with some signals ignored.
            for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
            const std::string command =
                fmt::format("exec '{}/bin/burl' {}", binary_folder(), arguments);
            ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            ::_exit(127);
        }
        ::close(ends[1]);
        pipe_ = ends[0];
    }
    ~Running() {
        ::close(pipe_);
        if (child_ > 0) ::kill(child_, SIGKILL), ::waitpid(child_, nullptr, 0);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    /// The first bytes on stderr, as soon as there are any.
    std::string first_words() const {
        char buffer[4096];
        const ssize_t count = ::read(pipe_, buffer, sizeof buffer);
        return {buffer, std::size_t(std::max<ssize_t>(count, 0))};
    }
    bool has_ended() {
        if (::waitpid(child_, &status_, WNOHANG) == child_) child_ = 0;
        return child_ == 0;
    }
    /// Sends the signal; the exit code as a shell counts it, and the seconds until the end.
    std::pair<int, double> end_by(int signal) {
        const auto start = Clock::now();
        ::kill(child_, signal);
        EXPECT_EQ(::waitpid(child_, &status_, 0), child_);
        child_ = 0;
        const std::chrono::duration<double> time = Clock::now() - start;
        return {WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_), time.count()};
    }

  private:
    pid_t child_ = 0;
    int pipe_ = -1, status_ = 0;
};

TEST(ProgressOfBakes, ComesWhileTheBakeRuns) {
    const Scratch scratch;
    Running bake(long_bake(scratch / "a.png", "-q --progress json", 4096));
    EXPECT_TRUE(bake.first_words().starts_with('{'));
    EXPECT_FALSE(bake.has_ended());
}

TEST(InterruptedBakes, EndSoonAndLeaveNothing) {
    const Scratch scratch;
    const std::string out = scratch.write("a.glb", "old");
    std::mt19937 random(1);
    int ended = 0;
    for (const int signal : {SIGINT, SIGTERM, SIGINT, SIGINT, SIGHUP, SIGINT, SIGINT, SIGINT}) {
        Running bake(long_bake(out, "-q --levels all", 2048));
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 2000));
        if (bake.has_ended()) {
            EXPECT_NE(slurp(out), "old");
            fs::remove(scratch / "a.glb.burl.json");
            scratch.write("a.glb", "old");
            continue;
        }
        ++ended;
        const auto [code, seconds] = bake.end_by(signal);
        EXPECT_EQ(code, 128 + signal);
        EXPECT_LT(seconds, 2.0) << "0.2 on a machine with nothing else to do";
        EXPECT_EQ(slurp(out), "old");
        EXPECT_EQ(scratch.files(), 1u);
    }
    EXPECT_GT(ended, 2);
}

}  // namespace
}  // namespace burl::test
