#include "app/editor/jobs/loader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/surface/sample_meshes.h"

namespace burl {

DocumentLoader::DocumentLoader(EditSession& session, EditBaker& baker, TextureRequests& requests,
                               const std::string& mesh, const std::string& recipe,
                               std::function<void()> wake, std::string recent)
    : session_(session),
      baker_(baker),
      requests_(requests),
      first_mesh_(mesh),
      files_(std::move(wake), std::move(recent)) {
    files_.set_recipe(recipe);
    files_.open(mesh);
}

bool DocumentLoader::follow_document() {
    const std::uint64_t number = session_.history().document_number();
    const bool other = std::exchange(document_, number) != number;
    if (files_.recipe() != session_.recipe_path()) files_.set_recipe(session_.recipe_path());
    return other;
}

bool DocumentLoader::take() {
    const bool other = follow_document();
    const bool asked = files_.asks();
    for (FileRead& read : files_.take(session_.history().changed())) take(std::move(read));
    if (files_.asks() && !asked)
        session_.complain(fmt::format("{} has changed on disk, and the recipe here is not saved",
                                      files_.recipe()));
    return other;
}

void DocumentLoader::take(FileRead read) {
    const bool nothing_open = read.kind == FileKind::mesh && files_.mesh().empty();
    if (read.problem && nothing_open && read.path == first_mesh_) throw Error(*read.problem);
    // The file opened in its place cannot be read.
    if (read.problem && nothing_open) files_.open(first_mesh_);
    if (read.problem)
        session_.complain(read.problem->what());
    else if (read.kind == FileKind::mesh)
        take_mesh(std::move(read));
    else if (read.kind == FileKind::pose)
        take_pose(read);
    else
        take_recipe(std::move(read));
}

void DocumentLoader::take_mesh(FileRead read) {
    session_.tell(fmt::format("mesh {}{}: {} triangles, read in {:.2f} s", read.path,
                              read.again ? " again" : "", read.mesh->triangles.size(),
                              read.seconds));
    for (const std::string& note : sentences_of(read.mesh->notes))
        session_.tell(fmt::format("{}: {}", read.path, note));
    baker_.set_mesh(std::move(*read.mesh));
    posed_ = false;
    requests_.forget();
    if (read.path == std::exchange(next_mesh_, "") && !next_pose_.empty())
        files_.open_pose(std::exchange(next_pose_, ""));
}

void DocumentLoader::take_pose(const FileRead& read) {
    session_.tell(fmt::format("pose {}{}, read in {:.2f} s", read.path, read.again ? " again" : "",
                              read.seconds));
    baker_.set_pose(read.pose);
    posed_ = true;
    requests_.forget();
}

void DocumentLoader::open_posed(const std::string& mesh, const std::string& pose) {
    if (mesh == files_.mesh()) {
        if (!pose.empty() && pose != files_.pose()) files_.open_pose(pose);
        return;
    }
    next_mesh_ = mesh;
    next_pose_ = pose;
    files_.open(mesh);
}

void DocumentLoader::close_pose() {
    files_.close_pose();
    baker_.set_pose(nullptr);
    posed_ = false;
    requests_.forget();
}

/// Takes over a recipe that was read. A file that holds the present recipe, such as one just saved
/// by the editor, only counts as saved.
void DocumentLoader::take_recipe(FileRead read) {
    if (read.again && read.path != session_.recipe_path()) return;  // another was opened since
    if (read.again && *read.recipe == session_.recipe())
        return session_.history().open(std::move(*read.recipe), read.path);
    const double time = session_.time();
    session_.take_recipe(std::move(*read.recipe), read.path);
    if (read.again) session_.set_time(std::min(time, session_.recipe().animation.seconds));
}

}  // namespace burl
