#pragma once
// One bake from its command to its files. The mesh comes in a pipeline, which several bakes may
// share one after the other (`burl batch`).
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/bake/levels.h"
#include "app/bake/normals.h"
#include "app/bake/options.h"
#include "app/export/export.h"
#include "app/measure/report.h"
#include "app/pipeline/pipeline.h"

namespace burl {

/// What is written besides the texture.
struct BakeExtras {
    LevelsAsked levels{};
    NormalSpace normals = NormalSpace::none;
    bool has_normals() const { return normals != NormalSpace::none; }
};

/// What another bake with the same pipeline will want of it.
enum class LaterBake { none, mesh, atlas };

class BakeJob {
  public:
    /// Loads the recipe of every frame and checks all that can be known before the mesh is read.
    /// `settings` are the command's (bake_settings). Throws Error.
    BakeJob(const BakeCommand& command, const Json& settings);

    const BakeCommand& command() const { return command_; }
    /// Of the first frame.
    const Recipe& recipe() const { return recipes_[0]; }
    /// Every file that is read, or that the mesh's file names.
    const std::vector<std::string>& inputs() const { return inputs_; }
    /// Every file that will be written, but for reports (strip atlases may have fewer levels).
    std::vector<std::string> outputs() const { return outputs(extras_.levels.count); }

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
    struct Written;
    void set_up(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer) const;
    Written write_texture(Pipeline& pipeline, const std::string& path, const MeshPose* pose,
                          bool releases) const;
    Written write_bands(Pipeline& pipeline, const std::string& path) const;
    Json add_beside(std::vector<AtomicFile>& files, Pipeline& pipeline,
                    const std::string& shader) const;
    std::vector<std::string> texture_outputs(std::uint32_t levels) const;
    std::vector<std::string> outputs(std::uint32_t levels) const;
    void check() const;
    void check_files() const;
    void check_idle() const;
    Json what_it_is_made_from(const Json& settings) const;
    bool write_reports(const Json& report) const;
    bool wants_report() const { return command_.json || !command_.report.empty(); }

    BakeCommand command_;
    ImageKind kind_;
    std::vector<std::string> paths_;  ///< of all frames, or the one that was named
    std::vector<Recipe> recipes_;     ///< of the same
    BakeExtras extras_;
    std::vector<std::string> inputs_;
    Json made_from_;
};

}  // namespace burl
