#pragma once
// Textures of recipes through OpenGL, for the pipeline, and the choice between it and the host.
#include <memory>
#include <span>
#include <string>

#include "app/gl/device/context.h"
#include "app/pipeline/texture_synthesizer.h"

namespace burl {

/// Throws Error(unsupported) as create_gl_context does.
std::unique_ptr<TextureSynthesizer> make_gl_synthesizer(std::unique_ptr<GlContext> context);

/// What `--synth` means: null is the host. `gl` is OpenGL and throws Error(unsupported) for a
/// recipe that it cannot make, and as create_gl_context. `automatic` is OpenGL where a graphics
/// processor is behind it, the recipes can be made, and the first of them is made faster there
/// (measure_synthesis; its draws are in the report, too), and else the host: software OpenGL has
/// the same processors as the host and is not asked (docs/reference/opengl.md).
enum class SynthesisChoice { host, gl, automatic };
std::unique_ptr<TextureSynthesizer> choose_synthesizer(SynthesisChoice choice,
                                                       const std::string& platform,
                                                       std::span<const Recipe> recipes);

}  // namespace burl
