// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "setae/bytes/png_mark.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/imaging/contact_radius.hpp"
#include "setae/imaging/png_writer.hpp"

namespace setae::imaging {
namespace {

constexpr double min_width = 640;                                           // px of the picture
const cv::Scalar outline_colour(40, 160, 255), words_colour(80, 220, 255);  // blue, green, red

/// The frame in 8 bits from its darkest to its brightest level, enlarged by an integer factor.
cv::Mat canvas(const FramePixels& pixels, int factor) {
    const cv::Mat grey(static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), CV_32F,
                       const_cast<float*>(pixels.data()));
    cv::Mat bytes, picture;
    const double low = static_cast<double>(pixels.minCoeff()), high = static_cast<double>(pixels.maxCoeff());
    const double scale = high > low ? 255.0 / (high - low) : 0.0;
    grey.convertTo(bytes, CV_8U, scale, -low * scale);
    cv::resize(bytes, bytes, {}, factor, factor, cv::INTER_NEAREST);
    cv::cvtColor(bytes, picture, cv::COLOR_GRAY2BGR);
    return picture;
}

void draw(cv::Mat& picture, const EdgeEllipse& ellipse, const PictureRegion& region, int factor) {
    constexpr int shift = 4, sides = 360;  // 16ths of a pixel
    const auto place = [&](double x, double y) {
        // the centre of a pixel is the middle of its square
        const double factor_x = factor * (x - static_cast<double>(region.x) + 0.5) - 0.5,
                     factor_y = factor * (y - static_cast<double>(region.y) + 0.5) - 0.5;
        return cv::Point(static_cast<int>(std::lround(factor_x * (1 << shift))),
                         static_cast<int>(std::lround(factor_y * (1 << shift))));
    };
    std::vector<cv::Point> line;
    const double c = std::cos(ellipse.angle), s = std::sin(ellipse.angle);
    for (int k = 0; k < sides; ++k) {
        const double t = 2 * CV_PI * k / sides, u = ellipse.semi_major * std::cos(t),
                     v = ellipse.semi_minor * std::sin(t);
        line.push_back(place(ellipse.centre_x + c * u - s * v, ellipse.centre_y + s * u + c * v));
    }
    cv::polylines(picture, line, true, outline_colour, 1, cv::LINE_AA, shift);
    const double arm = 0.05 * ellipse.semi_minor + 2;
    cv::line(picture, place(ellipse.centre_x - arm, ellipse.centre_y), place(ellipse.centre_x + arm, ellipse.centre_y),
             outline_colour, 1, cv::LINE_AA, shift);
    cv::line(picture, place(ellipse.centre_x, ellipse.centre_y - arm), place(ellipse.centre_x, ellipse.centre_y + arm),
             outline_colour, 1, cv::LINE_AA, shift);
}

}  // namespace

void write_overlay(const std::string& path, const FrameSource& source, std::size_t index, const ContactRadius& found) {
    const auto frame = source.read(index);
    const auto region = source.region();
    const FramePixels pixels = frame.fault.empty() ? frame.pixels : FramePixels::Zero(region.height, region.width);
    const int factor =
        static_cast<int>(std::clamp(std::ceil(min_width / static_cast<double>(pixels.cols())), 1.0, 8.0));
    auto picture = canvas(pixels, factor);
    const auto& contact = found.contact;
    if (contact.state == FrameState::measured) draw(picture, contact.ellipse, region, factor);
    const auto words =
        contact.state == FrameState::measured
            ? fmt::format("frame {}: a = {:.2f} +- {:.2f} px, b/a {:.3f}, confidence {:.2f}", found.number,
                          contact.radius, contact.radius_standard_error, contact.roundness, contact.confidence)
            : fmt::format("frame {}: {}", found.number, to_string(contact.state));
    cv::putText(picture, words, {8, 20}, cv::FONT_HERSHEY_SIMPLEX, 0.5, {0, 0, 0}, 3, cv::LINE_AA);
    cv::putText(picture, words, {8, 20}, cv::FONT_HERSHEY_SIMPLEX, 0.5, words_colour, 1, cv::LINE_AA);
    bytes::write_whole_file(path, bytes::with_png_mark(png_of(picture)));
}

}  // namespace setae::imaging
