#pragma once
// Small mesh files for the reader tests, in a folder of the running test's own, as CTest runs cases
// side by side.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "atlas/base/error.h"
#include "atlas/mesh/mesh_builder.h"
#include "atlas/read/readers.h"
#include "tests/paths.h"

namespace burl::test {

/// Returns the folder binary_folder()/tmp/<suite>.<test>/, which is created if necessary.
inline std::filesystem::path test_folder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const auto folder = std::filesystem::path(test::binary_folder()) / "tmp" /
                        (std::string(info->test_suite_name()) + "." + info->name());
    std::filesystem::create_directories(folder);
    return folder;
}

inline std::string write_file(const std::string& name, const std::string& content) {
    const std::string path = (test_folder() / name).string();
    std::filesystem::remove(path);  // truncating a file instead makes ext4 write it to disk at once
    std::ofstream(path, std::ios::binary) << content;
    return path;
}

/// Reads a mesh from memory, as if it were a file in the test's folder.
inline Mesh read_text(const std::string& name, const std::string& content,
                      const ReadOptions& options = {}) {
    const std::string path = (test_folder() / name).string();
    return build_mesh(parse_mesh(buffer_from(content, path), options), path, options);
}

/// Expects an Error with `code` whose one-line message contains `part`.
inline void expect_error(const std::function<void()>& action, ExitCode code,
                         const std::string& part) {
    try {
        action();
        ADD_FAILURE() << "expected an error with: " << part;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
            << "message: " << error.what() << "\nexpected: " << part;
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "more than one line";
    }
}

inline void expect_invalid(const std::string& name, const std::string& content,
                           const std::string& part) {
    expect_error([&] { read_text(name, content); }, ExitCode::invalid_file, part);
}

/// Returns the bytes of `value` in this (little-endian) machine's order, or reversed.
template <typename Value>
std::string bytes_of(Value value, bool big_endian = false) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

inline double total_area(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += triangle_area(mesh, t);
    return area;
}

/// Returns the position of corner 3t+k.
inline Vec3d corner(const Mesh& mesh, std::size_t t, std::size_t k) {
    return mesh.positions[mesh.triangles[t][k]];
}

}  // namespace burl::test
