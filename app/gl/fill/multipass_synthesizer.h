#pragma once
// The synthesis by the papers' passes as a TextureSynthesizer of the pipeline.
#include <memory>
#include <span>
#include <string>

#include "app/gl/device/context.h"
#include "app/pipeline/texture_synthesizer.h"
#include "procedural/passes/plan.h"

namespace burl {

/// Creates a synthesizer that owns the context.
std::unique_ptr<TextureSynthesizer> make_multipass_synthesizer(std::unique_ptr<GlContext> context,
                                                               const MultipassOptions& options);

/// Creates a synthesizer for a bake of these recipes. Throws Error: usage for a recipe that the
/// passes cannot make, unsupported as create_gl_context does.
std::unique_ptr<TextureSynthesizer> choose_multipass(const MultipassOptions& options,
                                                     const std::string& platform,
                                                     std::span<const Recipe> recipes);

}  // namespace burl
