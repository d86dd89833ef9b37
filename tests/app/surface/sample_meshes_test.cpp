// The meshes in the program are those the build makes.
#include "app/surface/sample_meshes.h"

#include <gtest/gtest.h>

#include "atlas/base/error.h"
#include "tests/paths.h"

namespace burl {
namespace {

TEST(SampleMeshes, AreTheFilesOfTheBuild) {
    const std::vector<std::string> names = sample_mesh_names();
    EXPECT_GE(names.size(), 6u);
    for (const std::string& name : names) {
        const Mesh sample = sample_mesh("sample:" + name);
        const Mesh file = read_mesh(test::mesh_folder() + "/" + name + ".obj");
        EXPECT_EQ(sample.positions, file.positions) << name;
        EXPECT_EQ(sample.triangles, file.triangles) << name;
        EXPECT_EQ(sample.name, name);
    }
}

TEST(SampleMeshes, CubeIsClosedAndTurnedOutwards) {
    const Mesh cube = sample_mesh("sample:cube");
    EXPECT_EQ(cube.positions.size(), 8u);
    ASSERT_EQ(cube.triangles.size(), 12u);
    double volume = 0.0;
    for (const Triangle& t : cube.triangles)
        volume +=
            glm::dot(cube.positions[t[0]], glm::cross(cube.positions[t[1]], cube.positions[t[2]])) /
            6.0;
    EXPECT_EQ(volume, 8.0);
}

TEST(SampleMeshes, AnUnknownOneIsAUsageError) {
    EXPECT_TRUE(is_sample_mesh("sample:kettle"));
    EXPECT_FALSE(is_sample_mesh("./sample:kettle"));
    for (const char* name : {"sample:kettle", "sample:", "sample:teapot.obj"}) try {
            sample_mesh(name);
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
            EXPECT_NE(std::string(error.what()).find("teapot"), std::string::npos);
        }
}

}  // namespace
}  // namespace burl
