// SPDX-License-Identifier: GPL-3.0-or-later
#include "phase_cut.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

namespace setae::imaging {
namespace {

constexpr long surroundings = 12;        // squares around one whose levels count
constexpr double most_difference = 6.0;  // of one square

cv::Mat view(PixelMask& mask) { return {static_cast<int>(mask.rows()), static_cast<int>(mask.cols()), CV_8U, mask.data()}; }
cv::Mat view(CellMap& map) { return {static_cast<int>(map.rows()), static_cast<int>(map.cols()), CV_64F, map.data()}; }

PixelMask grown(PixelMask mask, long distance) {
    const int side = static_cast<int>(2 * distance + 1);
    cv::Mat target = view(mask);
    cv::dilate(target, target, cv::getStructuringElement(cv::MORPH_RECT, {side, side}), {-1, -1}, 1, cv::BORDER_REPLICATE);
    return mask;
}

CellMap summed_around(CellMap map) {
    const int side = static_cast<int>(2 * surroundings + 1);
    CellMap sums(map.rows(), map.cols());
    cv::Mat target = view(sums);
    cv::boxFilter(view(map), target, CV_64F, {side, side}, {-1, -1}, false, cv::BORDER_CONSTANT | cv::BORDER_ISOLATED);
    return sums;
}

/// Mean and variance of a phase around each square.
struct Surroundings {
    CellMap count, mean, variance;
};

Surroundings around(const CellMap& values, const CellMap& weight, const PixelMask& core, int label, const PixelMask& labels, double origin) {
    const CellMap own = weight * (labels == static_cast<std::uint8_t>(label)).cast<double>() * core.cast<double>();
    Surroundings found;
    found.count = summed_around(own);
    const CellMap shifted = values - origin;
    found.mean = summed_around(own * shifted) / found.count.max(1.0);
    found.variance = (summed_around(own * shifted.square()) / found.count.max(1.0) - found.mean.square()).max(0.0);
    found.mean += origin;
    return found;
}

}  // namespace

PixelMask away_from_border(const PixelMask& labels, long distance) { return (grown(labels, distance) == labels && grown(1 - labels, distance) == 1 - labels).cast<std::uint8_t>(); }

PixelMask minimum_cut(const CellMap& difference, double border_cost, const PixelMask& free, const PixelMask& labels) {
    const long rows = labels.rows(), columns = labels.cols();
    constexpr double side_share = std::numbers::pi / 4, diagonal_share = std::numbers::pi / (8 * std::numbers::sqrt2);
    const double side = border_cost * side_share, diagonal = border_cost * diagonal_share;
    Eigen::Array<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> vertex = decltype(vertex)::Constant(rows, columns, -1);
    const long count = (free != 0).count();
    cv::detail::GCGraph<double> graph(static_cast<unsigned>(count), static_cast<unsigned>(8 * count));
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column)
            if (free(row, column) != 0) vertex(row, column) = graph.addVtx();
    CellMap terminal = difference;
    const auto join = [&](long row, long column, long other_row, long other_column, double weight) {
        if (other_row < 0 || other_row >= rows || other_column < 0 || other_column >= columns) return;
        const int a = vertex(row, column), b = vertex(other_row, other_column);
        if (a >= 0 && b >= 0) graph.addEdges(a, b, weight, weight);
        else if (a >= 0) terminal(row, column) += labels(other_row, other_column) == 1 ? -weight : weight;
        else if (b >= 0) terminal(other_row, other_column) += labels(row, column) == 1 ? -weight : weight;
    };
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column) {
            join(row, column, row, column + 1, side);
            join(row, column, row + 1, column, side);
            join(row, column, row + 1, column + 1, diagonal);
            join(row, column, row + 1, column - 1, diagonal);
        }
    // the source is vacuum: cutting off from it costs what sample costs more
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column)
            if (vertex(row, column) >= 0) graph.addTermWeights(vertex(row, column), std::max(0.0, terminal(row, column)), std::max(0.0, -terminal(row, column)));
    graph.maxFlow();
    PixelMask cut = labels;
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column)
            if (vertex(row, column) >= 0) cut(row, column) = graph.inSourceSegment(vertex(row, column)) ? 0 : 1;
    return cut;
}

PixelMask cut_in_band(const CellMap& mean, const CellMap& weight, const PixelMask& labels, long width, double border_cost) {
    const PixelMask core = away_from_border(labels, 2);
    const PixelMask free = 1 - away_from_border(labels, width);
    const double origin = mean.mean();
    const auto vacuum = around(mean, weight, core, 0, labels, origin), sample = around(mean, weight, core, 1, labels, origin);
    const double floor = 1e-6 * std::max(1e-300, (mean - origin).square().mean());
    CellMap difference = CellMap::Zero(mean.rows(), mean.cols());
    for (long i = 0; i < mean.size(); ++i) {
        if (free.data()[i] == 0 || weight.data()[i] == 0 || vacuum.count.data()[i] < 10 || sample.count.data()[i] < 10) continue;
        const double v = vacuum.variance.data()[i] + floor, s = sample.variance.data()[i] + floor;
        const double dv = mean.data()[i] - vacuum.mean.data()[i], ds = mean.data()[i] - sample.mean.data()[i];
        const double more = 0.5 * (ds * ds / s - dv * dv / v) + 0.5 * std::log(s / v);
        difference.data()[i] = std::clamp(more, -most_difference, most_difference);
    }
    return minimum_cut(difference, border_cost, free, labels);
}

void remove_islands(PixelMask& sample, double least_area) {
    for (const int label : {1, 0}) {
        PixelMask own = (sample == static_cast<std::uint8_t>(label)).cast<std::uint8_t>();
        cv::Mat parts, statistics, centres;
        const int count = cv::connectedComponentsWithStats(view(own), parts, statistics, centres, 4, CV_32S);
        int largest = 0;
        for (int part = 1; part < count; ++part)
            if (largest == 0 || statistics.at<int>(part, cv::CC_STAT_AREA) > statistics.at<int>(largest, cv::CC_STAT_AREA)) largest = part;
        for (long row = 0; row < sample.rows(); ++row)
            for (long column = 0; column < sample.cols(); ++column) {
                const int part = parts.at<int>(static_cast<int>(row), static_cast<int>(column));
                if (part > 0 && part != largest && statistics.at<int>(part, cv::CC_STAT_AREA) < least_area) sample(row, column) = static_cast<std::uint8_t>(1 - label);
            }
    }
}

}  // namespace setae::imaging
