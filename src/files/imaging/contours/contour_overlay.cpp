// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/contour_overlay.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "setae/bytes/png_mark.hpp"
#include "setae/core/statistics.hpp"
#include "setae/imaging/png_writer.hpp"

namespace setae::imaging {
namespace {

constexpr double min_side = 800;  // px: smaller pictures are enlarged
// blue, green, red; distinguished by the colour-blind (Okabe, Ito 2008)
const cv::Scalar first_colour(0, 159, 230), other_colour(233, 180, 86), anchor_colour(66, 228, 240),
    hidden_colour(167, 121, 204), bar_colour(115, 158, 0);

/// Percentiles of the defined pixels.
struct Range {
    double low, high;
};

Range shown_range(const FramePixels& pixels) {
    std::vector<float> values;
    const long stride = std::max(1L, pixels.size() / 1'000'000);
    for (long i = 0; i < pixels.size(); i += stride)
        if (std::isfinite(pixels.data()[i])) values.push_back(pixels.data()[i]);
    if (values.empty()) return {0, 1};
    const auto at = [&](double share) { return static_cast<double>(lower_quantile(values, share)); };
    Range range{at(0.005), at(0.995)};
    if (!(range.high > range.low)) range = {at(0.0), at(1.0)};
    if (!(range.high > range.low)) range.high = range.low + 1;
    return range;
}

class Canvas {
public:
    Canvas(const FramePixels& pixels, long longest_side) {
        const auto longest = static_cast<double>(std::max(pixels.rows(), pixels.cols()));
        factor_ = longest < min_side ? std::ceil(min_side / longest)
                                     : std::min(1.0, static_cast<double>(longest_side) / longest);
        const cv::Mat grey(static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), CV_32F,
                           const_cast<float*>(pixels.data()));
        const auto range = shown_range(pixels);
        const double scale = 255.0 / (range.high - range.low);
        cv::Mat bytes;
        grey.convertTo(bytes, CV_8U, scale, -range.low * scale);
        if (factor_ != 1.0)
            cv::resize(bytes, bytes, {}, factor_, factor_, factor_ > 1 ? cv::INTER_NEAREST : cv::INTER_AREA);
        cv::cvtColor(bytes, picture_, cv::COLOR_GRAY2BGR);
    }

    void line(const Array1D& x, const Array1D& y, bool closed, const cv::Scalar& colour, int width) {
        std::vector<cv::Point> points;
        for (Index i = 0; i < x.size(); ++i) points.push_back(place(x[i], y[i]));
        cv::polylines(picture_, points, closed, colour, width, cv::LINE_AA, shift);
    }
    void ring(const Anchor& at) {
        cv::circle(picture_, place(at.x, at.y), 6 << shift, anchor_colour, 2, cv::LINE_AA, shift);
    }
    void box(const PictureRegion& r) {
        cv::rectangle(picture_, place(static_cast<double>(r.x) - 0.5, static_cast<double>(r.y) - 0.5),
                      place(static_cast<double>(r.x + r.width) - 0.5, static_cast<double>(r.y + r.height) - 0.5),
                      hidden_colour, 1, cv::LINE_AA, shift);
    }
    void words(const std::string& text, int row) {
        cv::putText(picture_, text, {8, 20 + 20 * row}, cv::FONT_HERSHEY_SIMPLEX, 0.5, {0, 0, 0}, 3, cv::LINE_AA);
        cv::putText(picture_, text, {8, 20 + 20 * row}, cv::FONT_HERSHEY_SIMPLEX, 0.5, {255, 255, 255}, 1, cv::LINE_AA);
    }
    [[nodiscard]] std::string png() const { return bytes::with_png_mark(png_of(picture_)); }

private:
    static constexpr int shift = 4;  // 16ths of a pixel

    /// The centre of a pixel is the middle of its square.
    [[nodiscard]] cv::Point place(double x, double y) const {
        const auto scaled = [&](double v) {
            return static_cast<int>(std::lround((factor_ * (v + 0.5) - 0.5) * (1 << shift)));
        };
        return {scaled(x), scaled(y)};
    }

    cv::Mat picture_;
    double factor_ = 1;
};

}  // namespace

std::string overlay_png(const FramePixels& pixels, const ContourTrace& trace, const OverlayOptions& options) {
    Canvas canvas(pixels, options.longest_side);
    for (const auto& region : options.hidden) canvas.box(region);
    for (std::size_t i = trace.segments.size(); i-- > 0;) {
        const auto& segment = trace.segments[i];
        canvas.line(segment.x, segment.y, segment.closed, i == 0 ? first_colour : other_colour, 1);
    }
    for (const auto& list : options.anchors)
        for (const auto& anchor : list) canvas.ring(anchor);
    int row = 0;
    if (options.calibration) {
        if (const auto& bar = options.calibration->scale_bar) {
            Array1D x(2), y(2);
            x << bar->begin_x, bar->end_x;
            y.setConstant(bar->y);
            canvas.line(x, y, false, bar_colour, 2);
        }
        canvas.words(
            fmt::format("pixel {:.4g} nm ({})", 1e9 * options.calibration->pixel_size.x, options.calibration->source),
            row++);
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(trace.segments.size(), 4); ++i) {
        const auto& segment = trace.segments[i];
        if (trace.binary)
            canvas.words(fmt::format("{}: {:.0f} px along borders of pixels", i + 1, segment.length), row++);
        else
            canvas.words(fmt::format("{}: {:.0f} px, error {:.2f} px, contrast {:.1f} x noise, blur {:.2f} px", i + 1,
                                     segment.length, segment.standard_error.mean(), segment.contrast_to_noise,
                                     segment.edge_width),
                         row++);
    }
    return canvas.png();
}

}  // namespace setae::imaging
