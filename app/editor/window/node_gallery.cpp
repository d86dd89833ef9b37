#include "app/editor/window/node_gallery.h"

#include <vector>

#include "app/editor/jobs/thumbnails.h"
#include "app/editor/window/imgui.h"

namespace burl {

namespace {

constexpr int picture_pixels = 64;  // a power of two, as MIP levels are made of it
constexpr std::size_t most_node_textures = 600;

}  // namespace

void GlNodeGallery::follow(const EditGraph& graph, EditSession& session, const BallScene& scene) {
    if (!graph.shown || session.moving()) return;
    if (revision_ != session.history().revision() || scene_ != scene) {
        revision_ = session.history().revision();
        scene_ = scene;
        asked_.clear();
        pictures_.cancel();
        pictures_.set_light(scene.light);
    }
    std::vector<std::string> places;
    for (const std::string& place : graph.seen())
        if (asked_.insert(place).second) places.push_back(place);
    if (!places.empty()) pictures_.request(session.still(), scene.mesh, places, picture_pixels);
}

ImTextureID GlNodeGallery::picture(const GraphNodeView& node) {
    const NodePictures::Picture picture = pictures_.picture(node.place);
    if (!picture) return nullptr;
    auto found = textures_.find(picture.get());
    if (found == textures_.end()) {
        if (textures_.size() >= most_node_textures) textures_.clear();
        GlTexture texture = upload_levels(*gl_, picture_levels(*picture), GL_RGB8);
        found = textures_.emplace(picture.get(), Shown{picture, std::move(texture)}).first;
    }
    return imgui_texture(found->second.texture);
}

}  // namespace burl
