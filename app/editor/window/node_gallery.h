#pragma once
// The pictures of the graph's nodes as OpenGL textures.
#include <imgui.h>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/editor/graph/graph.h"
#include "app/editor/jobs/node_pictures.h"
#include "app/gl/device/objects.h"

namespace burl {

/// The mesh of nodes' pictures, and the light of those on balls.
struct BallScene {
    std::string mesh{};  ///< a file or sample:NAME
    BallLight light{};
    bool operator==(const BallScene&) const = default;
};

/// Asks for pictures and uploads them. All functions are called by the user interface's thread,
/// with the OpenGL context current.
class GlNodeGallery {
  public:
    /// `wake` is called by another thread whenever a picture is ready.
    GlNodeGallery(const GladGLContext& gl, std::function<void()> wake)
        : gl_(&gl), pictures_(std::move(wake)) {}

    /// Asks for pictures in this light of the nodes that the graph shows, those of masks on the
    /// mesh, unless the recipe is just changing.
    void follow(const EditGraph& graph, EditSession& session, const BallScene& scene);
    /// The picture of a node; null: none is ready.
    ImTextureID picture(const GraphNodeView& node);

    void hold(bool held) { pictures_.hold(held); }
    bool idle() const { return pictures_.idle(); }
    void wait() const { pictures_.wait(); }

  private:
    /// A picture of a node, and what the node was when it was asked for.
    struct Shown {
        NodePictures::Picture picture;
        GlTexture texture;
    };

    const GladGLContext* gl_;
    std::map<const Image<Rgb8>*, Shown> textures_;
    std::optional<std::uint64_t> revision_;  ///< of the recipe whose pictures were asked for
    BallScene scene_;                        ///< for which they were asked
    std::set<std::string> asked_;            ///< places that were asked for
    NodePictures pictures_;
};

}  // namespace burl
