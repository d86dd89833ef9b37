#pragma once
// The inputs of a surface shader, with their defaults, and which of them a recipe has no channel
// for.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/materialx/reader.h"

namespace burl::materialx {

/// An input that no channel holds.
struct LostInput {
    std::string_view name;
    std::vector<double> otherwise{};  ///< its default, at which nothing is lost
    std::string_view weight{};        ///< the input without which it has no effect; empty: none
};

/// Inputs of one shader.
class ShaderInputs {
  public:
    ShaderInputs(Reader& reader, const Target& shader) : reader_(reader), shader_(shader) {}

    Reader& reader() const { return reader_; }
    Arithmetic& values() const { return reader_.values; }
    const Target& shader() const { return shader_; }

    NodeRef number(std::string_view name, double otherwise) const;
    Value color(std::string_view name, double otherwise) const;
    /// A product of inputs, a weight and a colour.
    Value weighted(std::string_view weight, double weight_otherwise, std::string_view name,
                   double otherwise) const;
    /// Whether the input is the constant 0.
    bool is_zero(std::string_view name, double otherwise) const;

    /// Notes which of the inputs are not at their defaults, and which the shader has not.
    void note_lost(const std::vector<LostInput>& inputs,
                   std::span<const std::string_view> held) const;
    /// Notes a loss of the shader, whose name goes before the sentence.
    void lose(const std::string& sentence) const;

  private:
    bool is_lost(const LostInput& input) const;

    Reader& reader_;
    const Target& shader_;
};

}  // namespace burl::materialx
