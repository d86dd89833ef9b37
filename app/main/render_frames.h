#pragma once
// The pictures of `burl render` by whatever draws them: a scene through OpenGL, a recipe on a mesh
// as if baked (--lazy), or the texture itself (--direct).
#include <functional>

#include "app/export/command_files.h"
#include "app/main/render_command.h"

namespace burl {

/// A command's pictures: frames, each of cells.
struct RenderedFrames {
    std::function<Picture(std::size_t frame, std::size_t cell)> draw;
    /// Writes the report of --report on all pictures so far; null where none is asked for.
    std::function<void()> write_report{};
};

/// Loads all that the command draws, checks every frame and cell, and tells `files` what is read.
/// Throws Error.
RenderedFrames rendered_frames(const RenderCommand& command, CommandFiles& files);

/// Draws all frames and writes them to the files of command.paths(). Throws Error.
void write_frames(const RenderCommand& command, const RenderedFrames& frames);

}  // namespace burl
