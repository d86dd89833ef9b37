#pragma once
// One command of `burl bake`: its checks, its plan (app/bake/bake.h), its report and its record.
// The mesh is in a pipeline, which the bakes of a batch use one after the other.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/bake/bake.h"
#include "app/bake/groups.h"
#include "app/bake/options.h"
#include "app/measure/report.h"
#include "atlas/base/json.h"

namespace burl {

class CommandFiles;

/// The recipes of all frames, for the reference kernel if the command asks for it.
std::shared_ptr<const std::vector<Recipe>> frames_of(const BakeCommand& command);

/// One bake, checked when it is constructed.
class BakeJob {
  public:
    /// Loads the recipe of every frame and checks all that can be checked before the mesh is read.
    /// `settings` are the command's (bake_settings). Throws Error.
    BakeJob(const BakeCommand& command, const Json& settings);

    const BakeCommand& command() const { return command_; }
    /// Has the progress told of the bake; null: nobody is.
    void tell(Course* course) { command_.told = course; }
    /// Has files that are not known before the mesh is read compared with those of a batch.
    void compare_with(std::shared_ptr<const CommandFiles> batch) {
        batch_files_ = std::move(batch);
    }
    /// The recipe of the first frame.
    const Recipe& recipe() const { return recipes_->front(); }
    /// The number of pictures of the texture or material, without MIP levels and masks.
    std::size_t pictures() const;
    /// All files that are read, or that the mesh's file names.
    const std::vector<std::string>& inputs() const { return inputs_; }
    /// All files that will be written, except reports and the record. (Strip atlases may have fewer
    /// levels than asked for; with --udim each of these stands for one file per tile.)
    std::vector<std::string> outputs() const { return outputs(plan_.paths, plan_.levels.count); }

    /// All that the outputs depend on (app/bake/up_to_date.h), with the content of files when the
    /// job was constructed: files that a batch reads once for many bakes may change later.
    const Json& made_from() const { return made_from_; }

    /// The synthesizer of the textures; null: the host. Throws Error if the options contradict each
    /// other or OpenGL cannot make the recipe.
    std::shared_ptr<TextureSynthesizer> synthesizer() const;

    /// Bakes: writes the outputs and the record of made_from, and returns the report. The pipeline
    /// must hold the command's mesh; memory that a `later` bake does not reuse is freed early.
    /// `reading` is the time in seconds that reading the mesh took. Throws Error.
    Json run(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer, double reading,
             LaterBake later) const;

    /// The report of an earlier bake whose outputs are up to date, marked as such; none if the
    /// command has to be baked.
    std::optional<Json> known_report() const;

    /// Writes a report to where the command asks for it, and prints its summary unless --json,
    /// --report - or --quiet is given.
    void print(const Json& report) const;

  private:
    BakeJob(std::vector<BakeGroup> groups, const Json& settings);
    std::shared_ptr<KeptScene> kept_scene() const;
    BakeResult bake_into(Pipeline& pipeline, std::shared_ptr<TextureSynthesizer> synthesizer,
                         const std::shared_ptr<KeptScene>& kept, LaterBake later) const;
    void bake_others(const std::shared_ptr<KeptScene>& kept, BakeResult& result,
                     Json& reports) const;
    BakeCommand command_of(const BakeShare& share) const;
    std::vector<Recipe> load_shares() const;
    std::span<const Recipe> recipes_of_atlas() const;
    void check_shares() const;
    std::vector<Recipe> shared_recipes(const Mesh& mesh) const;
    std::vector<std::uint32_t> labels_of(const GltfOrigins& origins) const;
    std::vector<std::string> recipe_losses() const;
    bool kept_document() const;
    KeyTrack pose_keys() const;
    std::vector<std::string> losses_before(const Mesh& mesh) const;
    std::vector<std::string> paths_of(const std::string& out, std::uint32_t levels) const;
    std::vector<std::string> document_outputs(std::uint32_t levels) const;
    Json report_of(Pipeline& pipeline, const Recipe& recipe, const BakeResult& result,
                   const TextureSynthesizer* synthesizer, Json seconds) const;
    std::vector<std::string> outputs(const std::vector<std::string>& paths,
                                     std::uint32_t levels) const;
    void check() const;
    void check_files(const std::vector<std::string>& paths) const;
    void check_tiles(const std::vector<std::string>& paths) const;
    bool needs_host() const;
    bool names_files_of_mesh() const;
    std::string not_of(const Recipe& recipe) const;
    double noises() const;
    void check_displacement() const;
    void check_coding() const;
    void check_strips() const;
    void check_bare_surface() const;
    void check_masks() const;
    void warn_of_values() const;
    void warn_of_depth() const;
    void warn_of_strips(const StripCounts& counts) const;
    void check_idle() const;
    Json what_it_is_made_from(const Json& settings) const;
    bool has_normals() const { return plan_.normals != NormalSpace::none; }
    bool wants_report() const { return command_.json || !command_.report.empty(); }

    BakeCommand command_;
    std::string pictures_;           ///< the path after which pictures beside a .gltf are named
    std::vector<BakeShare> shares_;  ///< the recipes that share the atlas; empty: one
    std::vector<BakeJob> others_;    ///< further atlases of the same document
    std::shared_ptr<const std::vector<Recipe>> recipes_;  ///< one per frame, which plan_ gives, too
    std::vector<Recipe> sharing_;  ///< the recipes of the shares, in one atlas
    BakePlan plan_;
    std::vector<std::string> inputs_;
    Json made_from_;
    std::shared_ptr<const CommandFiles> batch_files_;
};

}  // namespace burl
