// burl-meshes FOLDER: writes every sample mesh as .obj, and the torus in each other format too.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "assets/make_meshes/model.h"
#include "assets/make_meshes/write_model.h"

namespace {

class Folder {
  public:
    explicit Folder(std::filesystem::path path) : path_(std::move(path)) {
        std::filesystem::create_directories(path_);
    }

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream file(path_ / name, std::ios::binary);
        file.exceptions(std::ios::failbit | std::ios::badbit);
        file << bytes << std::flush;
    }

  private:
    std::filesystem::path path_;
};

void write_all(const Folder& folder) {
    const burl::Model torus = burl::make_torus();
    folder.write("teapot.obj", obj_text(burl::make_teapot()));
    folder.write("king.obj", obj_text(burl::make_king()));
    folder.write("bust.obj", obj_text(burl::make_bust()));
    folder.write("icosphere.obj", obj_text(burl::make_icosphere()));
    folder.write("cube.obj", obj_text(burl::make_cube()));
    folder.write("cad_part.obj", obj_text(burl::make_cad_part()));
    folder.write("torus.obj", obj_text(torus));
    folder.write("torus.off", off_text(torus));
    folder.write("torus_ascii.ply", ply_text(torus));
    folder.write("torus_little.ply", ply_bytes(torus, false));
    folder.write("torus_big.ply", ply_bytes(torus, true));
    folder.write("torus_ascii.stl", stl_text(torus));
    folder.write("torus.stl", stl_bytes(torus));
    folder.write("torus.glb", glb_bytes(torus));
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        std::cerr << "usage: burl-meshes FOLDER\n";
        return 1;
    }
    try {
        write_all(Folder(arguments[1]));
    } catch (const std::exception& error) {
        std::cerr << "burl-meshes: cannot write to " << arguments[1] << ": " << error.what()
                  << '\n';
        return 2;
    }
    return 0;
}
