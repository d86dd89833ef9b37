#include "app/options/multipass_options.h"

#include <CLI/CLI.hpp>

#include "app/options/command_options.h"
#include "atlas/base/error.h"

namespace burl {

void MultipassCommand::add(CLI::App& verb) {
    verb.add_option("--gl-precision", precision_,
                    "Images of --synth gl-multipass: 32f (the default), 16f or 8 bits a channel")
        ->check(one_of({"32f", "16f", "8"}));
    verb.add_option("--gl-randomizer", randomizer_,
                    "Random numbers of --synth gl-multipass: hash (the default, as on the host), "
                    "table, or bits (8 bits only)")
        ->check(one_of({"hash", "table", "bits"}));
    verb.add_flag("--gl-equalize", equalize_,
                  "Make the Gaussian numbers of --gl-randomizer bits white");
}

MultipassOptions MultipassCommand::options(const std::string& synth) const {
    const char* given = !precision_.empty()    ? "--gl-precision"
                        : !randomizer_.empty() ? "--gl-randomizer"
                                               : "--gl-equalize";
    if (synth != multipass_synth && (!precision_.empty() || !randomizer_.empty() || equalize_))
        throw Error(ExitCode::usage, fmt::format("{} is of --synth {}; add that or leave it out",
                                                 given, multipass_synth));
    MultipassOptions options;
    if (precision_ == "16f") options.precision = PassPrecision::float16;
    if (precision_ == "8") options.precision = PassPrecision::fixed8;
    if (randomizer_ == "table") options.randomizer = Randomizer::table;
    if (randomizer_ == "bits") options.randomizer = Randomizer::bits;
    options.equalize = equalize_;
    return options;
}

}  // namespace burl
