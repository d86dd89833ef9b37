#pragma once
// Meshes, poses and recipes on their way from files to the session and the baker.
#include <cstdint>
#include <functional>
#include <string>

#include "app/editor/jobs/open_files.h"
#include "app/editor/jobs/requests.h"

namespace burl {

/// Takes over the files that were read. All functions are called by the user interface's thread.
class DocumentLoader {
  public:
    /// Begins to read `mesh`, which the editor was started with; `recipe` is the path of the
    /// session's recipe. `wake` and `recent` are those of EditOpenFiles.
    DocumentLoader(EditSession& session, EditBaker& baker, TextureRequests& requests,
                   const std::string& mesh, const std::string& recipe, std::function<void()> wake,
                   std::string recent);

    const EditOpenFiles& files() const { return files_; }
    EditOpenFiles& files() { return files_; }
    /// Whether the mesh has a pose.
    bool posed() const { return posed_; }
    void close_pose();
    /// Begins to read a mesh, unless it is open, and then a pose of it (empty: none).
    void open_posed(const std::string& mesh, const std::string& pose);

    /// Hands meshes and poses that were read to the baker and recipes to the session, which also
    /// logs problems. Returns whether the session shows another document than at the last call,
    /// after a preset was opened or undo has brought back an older one: selections are void then.
    /// Throws Error where the first mesh cannot be read.
    bool take();

  private:
    bool follow_document();
    void take(FileRead read);
    void take_mesh(FileRead read);
    void take_pose(const FileRead& read);
    void take_recipe(FileRead read);

    EditSession& session_;
    EditBaker& baker_;
    TextureRequests& requests_;
    std::string first_mesh_;      ///< mesh that the editor was started with
    std::uint64_t document_ = 0;  ///< EditHistory::document_number() at the last take()
    bool posed_ = false;
    std::string next_mesh_, next_pose_;  ///< mesh under way for open_posed(), and its pose
    EditOpenFiles files_;
};

}  // namespace burl
