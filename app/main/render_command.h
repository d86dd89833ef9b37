#pragma once
// The command line of `burl render`: what is drawn, from where, how often, and into which file.
#include <optional>
#include <string>
#include <vector>

#include "app/direct/picture.h"
#include "app/image/frame_writer.h"
#include "app/options/animation.h"
#include "app/options/command_options.h"
#include "app/scene/camera_path.h"

namespace burl {

struct RenderCommand {
    DirectOptions options;
    AnimationOptions animation;
    EconomyOptions economy;
    FrameFile file;
    int turntable = 0;                 ///< frames of one turn of the camera; 0: none
    std::vector<std::string> recipes;  ///< the texts of --recipes; none: one picture of --recipe
    int anisotropy = 1;                ///< lookups along a pixel's longer side, at most
    std::size_t columns = 0;           ///< of a sheet; 0: as many as rows, about
    std::string out, report, platform;
    std::string progress = "auto";  ///< a word of progress_modes
    std::optional<std::string> level_rule;
    bool direct = false, lazy = false;
    /// The moves of the camera, which complete() takes out of `animation`.
    CameraMoves camera;

    void add(CLI::App& verb);
    /// Throws Error(usage) for options in `given`, those on the command line, that have no effect
    /// together with the others.
    void check(const std::vector<std::string>& given) const;
    /// Follows what the options imply for one another: the camera's moves, the recipes of a sheet
    /// and the size of its pictures. Throws Error(usage).
    void complete();

    bool is_sheet() const { return !recipes.empty(); }
    /// The options of a cell of a sheet, or of the picture that is none.
    DirectOptions cell(std::size_t number) const;
    /// The number of a sheet's cells; 1 where there is no sheet.
    std::size_t cells() const { return is_sheet() ? recipes.size() : 1; }
    /// The view of every frame.
    std::vector<View> frame_views() const { return views(camera, options.parsed_view()); }
    /// The files that are written: one, or one per frame.
    std::vector<std::string> paths() const;
};

}  // namespace burl
