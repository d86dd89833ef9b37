#pragma once
// What baking publishes and the editor's windows show: a surface, its newest picture, BVH and atlas
// sheet. A new surface is announced ahead and takes the place of the one shown together with its
// first picture (double buffering).
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "app/editor/jobs/levels.h"
#include "app/editor/jobs/surface.h"
#include "app/editor/jobs/synthesis.h"
#include "app/measure/atlas_sheet.h"
#include "app/pipeline/stage_records.h"
#include "app/scene/material.h"

namespace burl {

/// A recipe's material as a surface's scene has it: its numbers, and its pictures besides normals
/// and an opaque base colour, by the numbers of the scene's textures, in OpenGL's format with the
/// coarser MIP levels.
struct EditMaterial {
    SceneMaterial numbers{};
    std::map<int, std::vector<Image<Rgba8>>> pictures{};
};

/// A texture baked for the surface whose number is `surface`, at one MIP level.
struct EditPicture {
    std::uint64_t number = 0, surface = 0, request = 0;
    std::uint32_t level = 0;  ///< MIP level; 0 is the finest
    std::uint32_t side = 0;   ///< texels a side
    /// The texels on the host; empty where OpenGL has them and nobody asked.
    Image<Rgb8> texels{};
    /// `texels` in OpenGL's format, with the coarser MIP levels.
    std::vector<Image<Rgba8>> levels{};
    /// The textures that OpenGL made, instead of `levels` and of the material's pictures.
    ResidentPicture resident{};
    std::string by{};      ///< who made it, in words
    double seconds = 0.0;  ///< time it took to bake, in seconds
    /// The material of the same recipe, at the same level.
    std::shared_ptr<const EditMaterial> material{};
    /// Normal map of the bumps; null: no bumps, or not baked yet.
    std::shared_ptr<const Image<Rgb8>> normals{};
};

/// The newest results, which all threads share; every function may be called by any thread.
class FrontBuffer {
  public:
    /// The newest surface; null: none yet.
    std::shared_ptr<const EditSurface> surface() const { return read(surface_); }
    /// The newest picture; null: none yet.
    std::shared_ptr<const EditPicture> picture() const { return read(picture_); }
    /// The surface that replaces surface() with its first picture, so that it can be uploaded
    /// meanwhile; null: none.
    std::shared_ptr<const EditSurface> coming() const { return read(coming_); }
    /// The BVH of the newest surface; null, or an older surface's (scene() then belongs to that
    /// one), until it is built and the newest surface's first picture is published.
    std::shared_ptr<const SurfacePick> pick() const { return read(pick_); }
    /// The atlas sheet of the newest surface; null: none, or none wanted.
    std::shared_ptr<const AtlasSheet> sheet() const;
    /// Records of the pipeline's stages, taken when the newest picture was published.
    StageRecords records() const { return read(records_); }

    /// Announces the surface that the next picture shows, and its BVH where it is built already
    /// (null: not). Numbers the surface.
    void announce(std::shared_ptr<EditSurface> surface,
                  std::shared_ptr<const SurfacePick> pick = nullptr);
    /// Whether the surface announced has its BVH already.
    bool coming_has_pick() const { return read(coming_pick_) != nullptr; }
    /// Publishes a picture of the surface announced, or of the one shown where none is. Numbers the
    /// picture.
    void publish(EditPicture picture, const StageRecords& records);
    /// Publishes the newest picture again, with another normal map.
    void publish(std::shared_ptr<const Image<Rgb8>> normals, const StageRecords& records);
    /// Publishes the BVH of a surface; false where another is shown.
    bool publish(const std::shared_ptr<const EditSurface>& of,
                 std::shared_ptr<const SurfacePick> pick);

    /// Whether a window shows the sheet.
    bool wants_sheet() const { return read(wants_sheet_); }
    /// Sets whether a window shows the sheet. Returns true where that begins now.
    bool want_sheet(bool wanted);
    /// Whether a window shows the sheet, and it is not that of the surface shown in this space.
    /// False while a surface is announced, whose atlas the pipeline then has.
    bool lacks_sheet(SolidSpace space) const;
    /// Publishes the sheet of the surface shown.
    void publish(std::shared_ptr<const AtlasSheet> sheet, SolidSpace space);

  private:
    template <class Member>
    Member read(const Member& member) const {
        const std::scoped_lock lock(mutex_);
        return member;
    }

    mutable std::mutex mutex_;  ///< guards all members
    std::shared_ptr<const EditSurface> surface_, coming_;
    std::shared_ptr<const SurfacePick> pick_, coming_pick_;  ///< the BVH of coming_, if built
    std::shared_ptr<const EditPicture> picture_;
    StageRecords records_;
    bool wants_sheet_ = false;
    std::shared_ptr<const AtlasSheet> sheet_;
    /// Number of the surface and space of which `sheet_` is.
    std::pair<std::uint64_t, SolidSpace> sheet_of_{};
    std::uint64_t numbers_ = 0;  ///< counter of surfaces and pictures
};

}  // namespace burl
