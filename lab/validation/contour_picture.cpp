// SPDX-License-Identifier: GPL-3.0-or-later
#include "contour_picture.hpp"

#include <cmath>
#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "setae/bytes/whole_file.hpp"
#include "setae/imaging/png_writer.hpp"

namespace setae::validation {
namespace {

constexpr int enlarged = 2;
const cv::Scalar true_curve_colour(255, 144, 64), trace_colour(40, 160, 255);  // blue, green, red

void draw(cv::Mat& picture, const Array1D& x, const Array1D& y, bool closed, const cv::Scalar& colour) {
    constexpr int shift = 4;  // one sixteenth of a pixel
    // a pixel's centre is the middle of the square it became
    const auto place = [](double at) {
        return static_cast<int>(std::lround((enlarged * (at + 0.5) - 0.5) * (1 << shift)));
    };
    std::vector<cv::Point> line;
    for (Index i = 0; i < x.size(); ++i) line.emplace_back(place(x[i]), place(y[i]));
    if (!line.empty()) cv::polylines(picture, line, closed, colour, 1, cv::LINE_AA, shift);
}

}  // namespace

void write_contour_picture(const std::string& folder, const ContourTrial& trial, const imaging::FramePixels& pixels,
                           const simulation::PixelCurve& truth, const imaging::ContourTrace& trace) {
    std::string kind = trial.kind;
    for (char& letter : kind)
        if (letter == ' ' || letter == ',' || letter == '+') letter = '_';
    const auto path = [&](const char* ending) {
        return (std::filesystem::path(folder) / fmt::format("{}_{:03d}{}", kind, trial.run, ending)).string();
    };
    const cv::Mat grey(static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), CV_32F,
                       const_cast<float*>(pixels.data()));
    const double low = static_cast<double>(pixels.minCoeff()), high = static_cast<double>(pixels.maxCoeff()),
                 scale = high > low ? 255.0 / (high - low) : 0.0;
    cv::Mat bytes, picture;
    grey.convertTo(bytes, CV_8U, scale, -low * scale);
    bytes::write_whole_file(path("_bare.png"), imaging::png_of(bytes));
    cv::resize(bytes, bytes, {}, enlarged, enlarged, cv::INTER_NEAREST);
    cv::cvtColor(bytes, picture, cv::COLOR_GRAY2BGR);
    draw(picture, truth.x, truth.y, false, true_curve_colour);
    for (const auto& segment : trace.segments) draw(picture, segment.x, segment.y, segment.closed, trace_colour);
    bytes::write_whole_file(path(".png"), imaging::png_of(picture));
    std::string points = "x,y\n";
    for (Index i = 0; i < truth.x.size(); ++i) points += fmt::format("{},{}\n", truth.x[i], truth.y[i]);
    bytes::write_whole_file(path("_truth.csv"), points);
}

}  // namespace setae::validation
