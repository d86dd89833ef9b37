// Writes sampled views of sample meshes for tests/peers/samplers.mjs: view_samples FOLDER. For each
// mesh NAME.json has the levels' sides, the views and our errors, NAME.levels the texels (RGBA,
// 32-bit floats, level after level), NAME.lookups eight floats a lookup (place and steps, over the
// texture's side, two unused), row after row, and NAME.means the true colours (three floats).
#include <fstream>

#include "atlas/base/json.h"
#include "tests/app/support/viewed_mesh.h"

namespace {

using namespace burl;

constexpr std::size_t points = 400;

void write(const std::string& path, const std::vector<float>& values) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(values.data()),
               std::streamsize(values.size() * sizeof(float)));
}

void write_mesh(const std::string& folder, const std::string& name, AtlasKind kind) {
    const ViewedMesh viewed = viewed_sample(name + ".obj", kind, points);
    std::vector<float> texels, lookups, means;
    nlohmann::json sides = nlohmann::json::array(), rows = nlohmann::json::array();
    for (const Image<Vec3f>& level : viewed.chain.levels) {
        sides.push_back(level.width());
        for (std::size_t y = 0; y < level.height(); ++y)
            for (const Vec3f& texel : level.row(y))
                texels.insert(texels.end(), {texel.x, texel.y, texel.z, 1.0f});
    }
    const double side = double(viewed.chain.levels[0].width());
    for (std::size_t r = 0; r < viewed.rows.size(); ++r) {
        const ViewRow& row = viewed.views.rows[r];
        nlohmann::json errors;
        for (const int most : {1, 2, 16})
            errors[std::to_string(most)] = viewed.error(r, viewed.values(r, most));
        rows.push_back(
            {{"minification", row.minification}, {"tilt", row.tilt}, {"errors", errors}});
        for (std::size_t i = 0; i < points; ++i) {
            const auto& [at, steps] = viewed.rows[r][i];
            for (const double v :
                 {at.x, at.y, steps.x.x, steps.x.y, steps.y.x, steps.y.y, 0.0, 0.0})
                lookups.push_back(float(v / side));
            for (int k = 0; k < 3; ++k) means.push_back(float(row.means[i][k]));
        }
    }
    const std::string path = folder + "/" + name;
    std::ofstream(path + ".json") << nlohmann::json{
        {"sides", sides},
        {"points", points},
        {"rows", rows}}.dump();
    write(path + ".levels", texels);
    write(path + ".lookups", lookups);
    write(path + ".means", means);
}

}  // namespace

int main(int, char** arguments) {
    write_mesh(arguments[1], "teapot", AtlasKind::patch);
    write_mesh(arguments[1], "king", AtlasKind::area);
    write_mesh(arguments[1], "bust", AtlasKind::patch);
}
