#pragma once
// The little of SVG that plots need: lines, text with its width known well enough to keep apart,
// and labels that find a free place.
#include <string>
#include <string_view>
#include <vector>

namespace burl {

/// Text as XML wants it.
std::string svg_escaped(std::string_view text);

/// At most as wide as so many characters are in the document's font.
double svg_width(std::size_t characters);

std::string svg_line(double x0, double y0, double x1, double y1, std::string_view color);

/// `anchor` is start, middle or end; `style` are further attributes.
std::string svg_text(double x, double y, std::string_view anchor, std::string_view text,
                     std::string_view style = {});

/// 10^exponent in few characters: 0.01 to 10000 written out.
std::string decade_text(int exponent);

/// A whole document on white, 11 px sans-serif.
std::string svg_document(double width, double height, std::string_view body);

struct SvgBox {
    double left = 0, top = 0, right = 0, bottom = 0;
    bool overlaps(const SvgBox& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

/// Labels within a box that overlap neither one another nor what is kept free.
class SvgLabels {
  public:
    explicit SvgLabels(const SvgBox& within) : within_(within) {}
    void keep_free(const SvgBox& box) { taken_.push_back(box); }
    /// The label near (x, y), with a thin line to it if it had to go further away.
    std::string place(double x, double y, std::string_view text);

  private:
    SvgBox within_;
    std::vector<SvgBox> taken_;
};

}  // namespace burl
