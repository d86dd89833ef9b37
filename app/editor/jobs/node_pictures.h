#pragma once
// Pictures of what the nodes of a graph give, each on a ball, or on the object where it reads
// masks, drawn beside the user interface.
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/jobs/mesh_picture.h"
#include "app/editor/jobs/thumbnails.h"
#include "app/editor/jobs/worker.h"
#include "app/recipe/recipe.h"
#include "atlas/base/image.h"

namespace burl {

/// Draws and keeps the pictures of one recipe's nodes. All functions may be called by one thread.
class NodePictures {
  public:
    using Picture = std::shared_ptr<const Image<Rgb8>>;

    /// `wake` is called by the drawing thread after every picture.
    explicit NodePictures(std::function<void()> wake);

    /// Sets the light, and drops what was asked for in another. Pictures in that are shown until
    /// they are asked for again and drawn.
    void set_light(BallLight light);
    /// Asks for pictures of the nodes at places of `recipe`, side x side pixels, on a ball or, of
    /// what reads masks, on the mesh of a file (or sample:NAME), which is read when it is first
    /// wanted. A picture that is there already is not drawn again.
    void request(const Recipe& recipe, const std::string& mesh,
                 const std::vector<std::string>& places, int side);
    /// Drops what was asked for and is not drawn yet.
    void cancel() { jobs_.cancel(); }
    /// The newest picture for a place; null: none is drawn yet, or the node cannot be drawn by
    /// itself.
    Picture picture(const std::string& place) const;

    /// While held, no picture is begun.
    void hold(bool held) { jobs_.hold(held); }
    bool idle() const { return jobs_.idle(); }
    void wait() const { jobs_.wait(); }

  private:
    /// The subject of a job.
    struct Ball {
        std::shared_ptr<const Recipe> recipe;
        std::string mesh, place;
        int side = 0;
        BallLight light;
    };
    void make(const Ball& ball);
    Picture drawn_on_mesh(const Recipe& look, const std::string& mesh, int side);
    Picture known(const std::string& key);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    // `mutex_` guards places_, drawn_ and light_.
    std::map<std::string, Picture> places_;  ///< pictures by places
    std::map<std::string, Picture> drawn_;   ///< pictures by side and JSON of what they show
    BallLight light_;
    // The drawing thread's alone.
    std::string mesh_path_;
    std::optional<MeshPictures> mesh_;  ///< of mesh_path_; none: not read, or it cannot be
    JobQueue jobs_;                     ///< last member: its thread uses all the others
};

}  // namespace burl
