// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/scale_bar.hpp"

#include <algorithm>

#include "drawn_bars.hpp"
#include "found_bars.hpp"
#include "scale_bar_label.hpp"

namespace setae::imaging {
namespace {

constexpr std::size_t max_bars = 4;  // maximum number of reported bars
constexpr int margin = 3;            // px around bar and label: blur, and dark rims of letters

PictureRegion region_of(const cv::Rect& box, const cv::Mat1f& levels) {
    const auto inside = cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
                        cv::Rect(0, 0, levels.cols, levels.rows);
    return {inside.x, inside.y, inside.width, inside.height};
}

}  // namespace

std::vector<FoundBar> found_bars(const cv::Mat1f& levels) {
    auto drawn = drawn_bars(levels);
    if (drawn.size() > max_bars) drawn.resize(max_bars);
    LabelRecogniser reader;
    std::vector<FoundBar> found;
    for (const auto& bar : drawn) {
        const auto label = read_label(levels, bar, reader);
        FoundBar result;
        result.bar = {.begin_x = bar.begin_x,
                      .end_x = bar.end_x,
                      .y = bar.y,
                      .thickness = bar.thickness,
                      .length = bar.end_x - bar.begin_x,
                      .length_standard_error = bar.length_standard_error,
                      .label = label.text,
                      .labelled_length = label.length,
                      .annotation = region_of(label.box ? bar.box | *label.box : bar.box, levels),
                      .confidence = bar.quality * (label.length         ? 1.0
                                                   : label.text.empty() ? 0.5
                                                                        : 0.6)};
        result.label_fault = label.fault;
        found.push_back(std::move(result));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const FoundBar& a, const FoundBar& b) { return a.bar.confidence > b.bar.confidence; });
    return found;
}

std::vector<ScaleBar> find_scale_bars(const FramePixels& pixels) {
    std::vector<ScaleBar> bars;
    for (auto& found : found_bars(scaled_levels(pixels))) bars.push_back(std::move(found.bar));
    return bars;
}

}  // namespace setae::imaging
