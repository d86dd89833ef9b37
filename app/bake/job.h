#pragma once
// One command of `burl bake`: everything it can be wrong about, its plan (app/bake/bake.h), its
// report and its record. The mesh comes in a pipeline, which the bakes of a batch share one after
// the other.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/bake/bake.h"
#include "app/bake/options.h"
#include "app/measure/report.h"

namespace burl {

class BakeJob {
  public:
    /// Loads the recipe of every frame and checks all that can be known before the mesh is read.
    /// `settings` are the command's (bake_settings). Throws Error.
    BakeJob(const BakeCommand& command, const Json& settings);

    const BakeCommand& command() const { return command_; }
    /// The recipe of the first frame.
    const Recipe& recipe() const { return plan_.recipes[0]; }
    /// Every file that is read, or that the mesh's file names.
    const std::vector<std::string>& inputs() const { return inputs_; }
    /// Every file that will be written, but for reports (strip atlases may have fewer levels).
    std::vector<std::string> outputs() const { return outputs(plan_.levels.count); }

    /// All that decides what the outputs will be (app/bake/up_to_date.h), files as they were when
    /// the job was made: what a batch reads once for many bakes may have changed since.
    const Json& made_from() const { return made_from_; }

    /// Who makes the textures; null: the host. Throws Error.
    std::shared_ptr<TextureSynthesizer> synthesizer() const;

    /// Writes the outputs, the report where one is asked for, and the record of made_from. The
    /// pipeline has the command's mesh; what a `later` bake does not want is given back early.
    /// `reading`: seconds that the mesh took. Gives the report. Throws Error.
    Json run(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer, double reading,
             LaterBake later) const;

    /// The report of an earlier bake whose outputs are up to date and may stay as they are.
    std::optional<Json> known_report() const;

    /// What `burl bake` says about it, and where.
    void print(const Json& report) const;
    /// The same of a report of earlier.
    void print_up_to_date(Json report) const;

  private:
    void set_up(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer) const;
    Json report_of(Pipeline& pipeline, const BakeResult& result,
                   const TextureSynthesizer* synthesizer, Json seconds) const;
    std::vector<std::string> texture_outputs(std::uint32_t levels) const;
    std::vector<std::string> outputs(std::uint32_t levels) const;
    void check() const;
    void check_files() const;
    void check_idle() const;
    Json what_it_is_made_from(const Json& settings) const;
    bool write_reports(const Json& report) const;
    bool has_normals() const { return plan_.normals != NormalSpace::none; }
    bool wants_report() const { return command_.json || !command_.report.empty(); }

    BakeCommand command_;
    BakePlan plan_;
    std::vector<std::string> inputs_;
    Json made_from_;
};

}  // namespace burl
