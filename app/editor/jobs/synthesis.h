#pragma once
// Who makes the texture on screen: the host, or OpenGL in a context of the worker thread's own,
// whose textures the window shows where they are.
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/gl/device/context.h"
#include "app/gl/fill/resident.h"
#include "app/pipeline/pipeline.h"
#include "atlas/base/enum_names.h"

namespace burl {

/// `automatic` is OpenGL where it runs on a graphics processor and is measured to be faster than
/// the host; `passes` are the papers'.
enum class EditSynthesis { automatic, host, gl, passes };
template <>
inline constexpr auto enum_names<EditSynthesis> = enum_words("auto", "host", "gl", "gl-multipass");

/// A person's choice.
struct SynthesisWish {
    EditSynthesis by = EditSynthesis::automatic;
    std::size_t pass = 0;  ///< the pass to look at, from 1 on; 0: the finished texture
    bool operator==(const SynthesisWish&) const = default;
};

/// A picture that OpenGL made, and the numbers of the scene's textures that its images are.
struct ResidentPicture {
    std::shared_ptr<const GlPictures> pictures{};
    std::vector<int> numbers{};
    std::optional<ShownPass> pass{};  ///< that is looked at
};

/// The synthesis of the baking thread, which alone calls make() and forget_atlas().
class EditSynthesizer {
  public:
    EditSynthesizer() = default;
    EditSynthesizer(const EditSynthesizer&) = delete;
    EditSynthesizer& operator=(const EditSynthesizer&) = delete;
    /// The thread that offered the context; make() must not be running.
    ~EditSynthesizer();

    /// Takes a context that shares the window's objects and is current nowhere, of software or of a
    /// graphics processor. May be called by any thread, once.
    void offer(std::unique_ptr<GlContext> context, bool software);
    bool has_context() const;

    /// The pipeline's recipe by OpenGL; empty where the host is to make it, for which words() gives
    /// the reason. `numbers` are those of the base colour's texture and of the plans' in the scene,
    /// `normals` that of the normal map (-1: none), which OpenGL makes where it can.
    std::optional<ResidentPicture> make(Pipeline& pipeline, const SynthesisWish& wish,
                                        const std::vector<PicturePlan>& plans,
                                        const std::vector<int>& numbers, int normals);
    /// The texels of a picture's base colour, level 0.
    Image<Rgb8> read(const ResidentPicture& picture);
    /// Must be called before the pipeline's atlas changes or is destroyed.
    void forget_atlas();
    /// Who made the last texture, and why, in words.
    const std::string& words() const { return words_; }

  private:
    struct Makers;
    Makers* makers();
    bool chooses_gl(const Recipe& recipe, const SynthesisWish& wish, Makers& made);
    void measure(const Recipe& recipe, Makers& made);
    static ResidentPicture pictures(Pipeline& pipeline, Makers& made,
                                    const std::vector<PicturePlan>& plans, std::vector<int> numbers,
                                    int normals);

    mutable std::mutex mutex_;  ///< guards context_ until the worker thread has seen it
    std::unique_ptr<GlContext> context_;
    bool software_ = false;
    std::unique_ptr<Makers> makers_;
    std::optional<bool> faster_;  ///< whether OpenGL is; empty: not measured
    std::string measured_;        ///< the measurement in words
    std::string words_ = "the host";
};

}  // namespace burl
