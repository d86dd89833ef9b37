#pragma once
// Synthesis of recipes' textures through OpenGL as a TextureSynthesizer of the pipeline, and the
// choice between OpenGL and the host.
#include <memory>
#include <span>
#include <string>

#include "app/gl/device/context.h"
#include "app/pipeline/texture_synthesizer.h"
#include "procedural/passes/plan.h"

namespace burl {

/// Creates a synthesizer that owns the context.
std::unique_ptr<TextureSynthesizer> make_gl_synthesizer(std::unique_ptr<GlContext> context);

/// The value of `--synth`. `gl` is OpenGL. `automatic` is OpenGL where it runs on a graphics
/// processor, can make all recipes, and makes the first of them faster than the host
/// (measure_synthesis, whose draws count in the report); otherwise it is the host. Software OpenGL
/// runs on the same processors as the host and is never chosen (docs/reference/opengl.md).
enum class SynthesisChoice { host, gl, automatic };
/// The synthesizer for these recipes; null means the host. Throws Error for `gl`: unsupported for a
/// recipe that OpenGL cannot make, and as create_gl_context does; for `automatic` only
/// Error(usage).
std::unique_ptr<TextureSynthesizer> choose_synthesizer(SynthesisChoice choice,
                                                       const std::string& platform,
                                                       std::span<const Recipe> recipes);

/// The synthesizer by the papers' passes for these recipes. Throws Error: usage for a recipe that
/// the passes cannot make, unsupported as create_gl_context does.
std::unique_ptr<TextureSynthesizer> choose_multipass(const MultipassOptions& options,
                                                     const std::string& platform,
                                                     std::span<const Recipe> recipes);

}  // namespace burl
