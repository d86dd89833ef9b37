#pragma once
// What tests of the library share: a folder, the program, a small mesh.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "burl/error.h"

namespace fs = std::filesystem;

/// A folder of its own for a test.
inline fs::path folder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    const fs::path path = fs::path(BURL_TEST_FOLDER) / test->name();
    fs::remove_all(path);
    fs::create_directories(path);
    return path;
}

inline std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs the program; its output must be `bake`'s.
inline void run_burl(const std::string& words) {
    const std::string command = std::string(BURL_PROGRAM) + " " + words + " --quiet >/dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

/// The kind of the error that `work` throws, and its sentence.
template <class Work>
std::pair<burl::ErrorKind, std::string> error_of(Work&& work) {
    try {
        work();
    } catch (const burl::Error& error) {
        return {error.kind(), error.what()};
    }
    return {burl::ErrorKind::runtime, "nothing was thrown"};
}

inline const std::vector<double> tetrahedron{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
inline const std::vector<std::uint32_t> faces{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
