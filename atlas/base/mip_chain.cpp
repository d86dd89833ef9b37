// The box filter is separable: the rectangle of a new texel is a product of two intervals.
#include "atlas/base/mip_chain.h"

#include <algorithm>
#include <span>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace burl {

namespace {

double widen(float value) {
    return double(value);
}
Vec3d widen(const Vec3f& value) {
    return Vec3d(value);
}
Vec4d widen(const Vec4f& value) {
    return Vec4d(value);
}
Vec3d widen(const RgbF& value) {
    return {double(value.r), double(value.g), double(value.b)};
}
Vec4d widen(const RgbaF& value) {
    return {double(value.r), double(value.g), double(value.b), double(value.a)};
}
void narrow(double sum, float& value) {
    value = float(sum);
}
void narrow(const Vec3d& sum, Vec3f& value) {
    value = Vec3f(sum);
}
void narrow(const Vec4d& sum, Vec4f& value) {
    value = Vec4f(sum);
}
void narrow(const Vec3d& sum, RgbF& value) {
    value = {float(sum.x), float(sum.y), float(sum.z)};
}
void narrow(const Vec4d& sum, RgbaF& value) {
    value = {float(sum.x), float(sum.y), float(sum.z), float(sum.w)};
}

float times(float value, float factor) {
    return value * factor;
}
Vec4f times(const Vec4f& value, float factor) {
    return value * factor;
}
RgbF times(const RgbF& p, float factor) {
    return {p.r * factor, p.g * factor, p.b * factor};
}
RgbaF times(const RgbaF& p, float factor) {
    return {p.r * factor, p.g * factor, p.b * factor, p.a * factor};
}

/// Filter taps of new texel i of an axis with `size` old ones.
MipTaps taps(std::size_t size, std::size_t i) {
    if (size == 1) return {};
    if (size % 2 == 0) return {2 * i, 2, {0.5, 0.5, 0.0}};
    const std::size_t half = size / 2;
    const double n = double(size);
    return {2 * i, 3, {double(half - i) / n, double(half) / n, double(i + 1) / n}};
}

/// The means over the products of columns and rows of an image's pixels, which at(x, y) returns.
template <class T, class At>
Image<T> means_at(std::span<const MipTaps> columns, std::span<const MipTaps> rows, const At& at) {
    auto result = Image<T>::unset(columns.size(), rows.size());
    const auto weighted = [&](const MipTaps& x, const MipTaps& y) {
        decltype(widen(T{})) sum(0.0);
        for (std::size_t j = 0; j < y.count; ++j)
            for (std::size_t i = 0; i < x.count; ++i)
                sum += y.weight[j] * x.weight[i] * widen(at(x.first + i, y.first + j));
        return sum;
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows.size(), 16), [&](const auto& range) {
        for (std::size_t y = range.begin(); y < range.end(); ++y)
            for (std::size_t x = 0; x < columns.size(); ++x)
                narrow(weighted(columns[x], rows[y]), result(x, y));
    });
    return result;
}

/// The MIP level after an image of `width` x `height` pixels, which at(x, y) returns.
template <class T, class At>
Image<T> halve_at(std::size_t width, std::size_t height, const At& at) {
    return means_at<T>(mip_taps(width), mip_taps(height), at);
}

/// The rows of one image and below them those of another, of which the first may be empty.
template <class T>
Image<T> joined(const Image<T>& above, const Image<T>& below) {
    auto result = Image<T>::unset(below.width(), above.height() + below.height());
    std::ranges::copy(above.pixels(), result.row(0).begin());
    std::ranges::copy(below.pixels(), result.row(above.height()).begin());
    return result;
}

}  // namespace

std::vector<MipTaps> mip_taps(std::size_t size) {
    std::vector<MipTaps> result;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, size / 2); ++i)
        result.push_back(taps(size, i));
    return result;
}

template <class T>
Image<T> halve(const Image<T>& image) {
    return halve_at<T>(image.width(), image.height(),
                       [&](std::size_t x, std::size_t y) -> const T& { return image(x, y); });
}

template <class T>
Image<T> halve_product(const Image<T>& image, const Image<float>& factor) {
    return halve_at<T>(image.width(), image.height(), [&](std::size_t x, std::size_t y) {
        return times(image(x, y), factor(x, y));
    });
}

template <class T>
void HalvedRows<T>::add(const Image<T>& rows) {
    const bool carries = carried_.height() > 0;
    const Image<T> both = carries ? joined(carried_, rows) : Image<T>();
    const Image<T>& known = carries ? both : rows;
    const std::size_t end = first_ + known.height();
    std::vector<MipTaps> whole;  // of the new rows whose old ones are all known
    const auto row = [&] { return taps(height_, next_ + whole.size()); };
    while (next_ + whole.size() < level_.height() && row().first + row().count <= end) {
        whole.push_back(row());
        whole.back().first -= first_;
    }
    const Image<T> halved =
        means_at<T>(mip_taps(known.width()), whole,
                    [&](std::size_t x, std::size_t y) -> const T& { return known(x, y); });
    std::ranges::copy(halved.pixels(), level_.row(next_).begin());
    next_ += whole.size();
    const std::size_t kept =
        next_ < level_.height() ? std::min(taps(height_, next_).first, end) : end;
    const std::size_t old_first = std::exchange(first_, kept);
    auto carried = Image<T>::unset(known.width(), end - kept);
    std::ranges::copy(known.pixels().subspan((kept - old_first) * known.width()),
                      carried.row(0).begin());
    carried_ = std::move(carried);
}

template <class T>
MipChain<T> build_mip_chain(Image<T> image) {
    MipChain<T> chain;
    chain.levels.push_back(std::move(image));
    while (chain.levels.back().width() > 1 || chain.levels.back().height() > 1)
        chain.levels.push_back(halve(chain.levels.back()));
    return chain;
}

template Image<float> halve(const Image<float>&);
template Image<Vec3f> halve(const Image<Vec3f>&);
template Image<Vec4f> halve(const Image<Vec4f>&);
template Image<RgbF> halve(const Image<RgbF>&);
template Image<RgbaF> halve(const Image<RgbaF>&);
template Image<float> halve_product(const Image<float>&, const Image<float>&);
template Image<Vec4f> halve_product(const Image<Vec4f>&, const Image<float>&);
template Image<RgbF> halve_product(const Image<RgbF>&, const Image<float>&);
template Image<RgbaF> halve_product(const Image<RgbaF>&, const Image<float>&);
template class HalvedRows<float>;
template class HalvedRows<Vec4f>;
template class HalvedRows<RgbF>;
template class HalvedRows<RgbaF>;
template MipChain<float> build_mip_chain(Image<float>);
template MipChain<Vec3f> build_mip_chain(Image<Vec3f>);
template MipChain<RgbF> build_mip_chain(Image<RgbF>);
template MipChain<RgbaF> build_mip_chain(Image<RgbaF>);

}  // namespace burl
