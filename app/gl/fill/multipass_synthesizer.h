#pragma once
// Textures of recipes by the papers' passes on OpenGL, for the pipeline.
#include <memory>
#include <span>
#include <string>

#include "app/gl/device/context.h"
#include "app/pipeline/texture_synthesizer.h"
#include "procedural/passes/plan.h"

namespace burl {

std::unique_ptr<TextureSynthesizer> make_multipass_synthesizer(std::unique_ptr<GlContext> context,
                                                               const MultipassOptions& options);

/// The same for a bake of these recipes. Throws Error: usage for what the passes cannot make,
/// unsupported as create_gl_context.
std::unique_ptr<TextureSynthesizer> choose_multipass(const MultipassOptions& options,
                                                     const std::string& platform,
                                                     std::span<const Recipe> recipes);

}  // namespace burl
