#pragma once
// The pictures of a material at the texels that a view looks up: base colour with its levels, the
// normal map, and those of the other channels.
#include <map>

#include "app/gl/draw/lazy_picture.h"
#include "app/gl/draw/scene.h"

namespace burl {

/// The pictures of a baked scene (app/gl/draw/view_scene.h), made for a view.
class ViewPictures {
  public:
    /// The pipeline and the scene must outlive the object.
    ViewPictures(Pipeline& pipeline, const Scene& scene, const LazyOptions& options);

    const ViewSource& source() const { return source_; }
    /// Synthesises the texels that `texels` looks up, and tells the work; `filter` is that of the
    /// colours' lookups.
    void make(const ViewTexels& texels, TextureFilter filter, ViewWork& work);
    /// Moves what was made into the scene's textures.
    void upload(GlScene& drawn);

  private:
    void make_colors(const ViewTexels& texels, TextureFilter filter, ViewWork& work);
    void make_material(const TexelSet& texels, ViewWork& work);
    void make_normals(const TexelSet& texels);

    Pipeline& pipeline_;
    const Scene& scene_;
    LazyOptions options_;
    const SceneMaterial& material_;
    bool varies_;  ///< whether there are pictures besides an opaque base colour and normals
    ViewSource source_;
    std::map<int, SceneTexture> made_;  ///< by the scene's numbers
};

}  // namespace burl
