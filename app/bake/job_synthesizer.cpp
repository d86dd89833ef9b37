// Who makes the textures of a bake: the host, or OpenGL as the options of --synth say.
#include <fmt/format.h>

#include "app/bake/job.h"
#include "app/gl/fill/synthesizer.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// The options of --synth gl-multipass. Throws Error(usage) where one is given without it.
MultipassOptions multipass_options(const BakeCommand& command) {
    const std::string given = !command.gl_precision.empty()    ? "--gl-precision"
                              : !command.gl_randomizer.empty() ? "--gl-randomizer"
                              : command.gl_equalize            ? "--gl-equalize"
                                                               : "";
    if (command.synth != multipass_synth && !given.empty())
        throw Error(ExitCode::usage, fmt::format("{} is of --synth {}; add that or leave it out",
                                                 given, multipass_synth));
    MultipassOptions options;
    if (command.gl_precision == "16f") options.precision = PassPrecision::float16;
    if (command.gl_precision == "8") options.precision = PassPrecision::fixed8;
    if (command.gl_randomizer == "table") options.randomizer = Randomizer::table;
    if (command.gl_randomizer == "bits") options.randomizer = Randomizer::bits;
    options.equalize = command.gl_equalize;
    return options;
}

}  // namespace

// OpenGL gives the bits of the kernels `direct` and `share`, so it takes no other kernel.
std::shared_ptr<TextureSynthesizer> BakeJob::synthesizer() const {
    const std::string &kernel = command_.kernel, &synth = command_.synth;
    const bool any = kernel == "auto" || kernel == "direct" || kernel == "share";
    const MultipassOptions multipass = multipass_options(command_);
    if (!any && synth.starts_with("gl"))
        throw Error(ExitCode::usage,
                    fmt::format("--kernel {} is the host's alone; leave it or --synth {} out",
                                kernel, synth));
    if (synth == "host" && !command_.platform.empty())
        throw Error(ExitCode::usage,
                    "--gl says where OpenGL comes from, and the host makes the texture; add "
                    "--synth gl, gl-multipass or auto, or leave --gl out");
    const std::string platform = command_.platform.empty() ? gl_platforms()[0] : command_.platform;
    if (synth == multipass_synth) return choose_multipass(multipass, platform, *recipes_);
    const SynthesisChoice choice = synth == "host" || !any ? SynthesisChoice::host
                                   : synth == "gl"         ? SynthesisChoice::gl
                                                           : SynthesisChoice::automatic;
    return choose_synthesizer(choice, platform, *recipes_);
}

}  // namespace burl
