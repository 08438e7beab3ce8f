// SPDX-License-Identifier: GPL-3.0-or-later
#include "phase_cut.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

namespace setae::imaging {
namespace {

constexpr long surroundings = 12;       // squares around a square for its levels
constexpr double max_difference = 6.0;  // of one square
constexpr long tile_side = 128;         // squares

cv::Mat view(PixelMask& mask) {
    return {static_cast<int>(mask.rows()), static_cast<int>(mask.cols()), CV_8U, mask.data()};
}
cv::Mat view(CellMap& map) { return {static_cast<int>(map.rows()), static_cast<int>(map.cols()), CV_64F, map.data()}; }

PixelMask grown(PixelMask mask, long distance) {
    const int side = static_cast<int>(2 * distance + 1);
    cv::Mat target = view(mask);
    cv::dilate(target, target, cv::getStructuringElement(cv::MORPH_RECT, {side, side}), {-1, -1}, 1,
               cv::BORDER_REPLICATE);
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

Surroundings around(const CellMap& values, const CellMap& weight, const PixelMask& core, int label,
                    const PixelMask& labels, double origin) {
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

PixelMask away_from_border(const PixelMask& labels, long distance) {
    return (grown(labels, distance) == labels && grown(1 - labels, distance) == 1 - labels).cast<std::uint8_t>();
}

namespace {

using Vertices = Eigen::Array<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Numbers of the free squares by rows, −1 elsewhere.
Vertices numbered(const PixelMask& free) {
    Vertices vertex = Vertices::Constant(free.rows(), free.cols(), -1);
    std::int32_t count = 0;
    for (long i = 0; i < free.size(); ++i)
        if (free.data()[i] != 0) vertex.data()[i] = count++;
    return vertex;
}

/// terminal: difference of each vertex.
PixelMask cut_of(const Vertices& vertex, std::vector<double> terminal, double border_cost, const PixelMask& labels) {
    if (terminal.empty()) return labels;
    const long rows = labels.rows(), columns = labels.cols();
    constexpr double side_share = std::numbers::pi / 4, diagonal_share = std::numbers::pi / (8 * std::numbers::sqrt2);
    const double side = border_cost * side_share, diagonal = border_cost * diagonal_share;
    cv::detail::GCGraph<double> graph(static_cast<unsigned>(terminal.size()),
                                      static_cast<unsigned>(8 * terminal.size()));
    for (std::size_t i = 0; i < terminal.size(); ++i) graph.addVtx();
    const auto join = [&](long row, long column, long other_row, long other_column, double weight) {
        if (other_row < 0 || other_row >= rows || other_column < 0 || other_column >= columns) return;
        const int a = vertex(row, column), b = vertex(other_row, other_column);
        if (a >= 0 && b >= 0) graph.addEdges(a, b, weight, weight);
        else if (a >= 0)
            terminal[static_cast<std::size_t>(a)] += labels(other_row, other_column) == 1 ? -weight : weight;
        else if (b >= 0) terminal[static_cast<std::size_t>(b)] += labels(row, column) == 1 ? -weight : weight;
    };
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column) {
            join(row, column, row, column + 1, side);
            join(row, column, row + 1, column, side);
            join(row, column, row + 1, column + 1, diagonal);
            join(row, column, row + 1, column - 1, diagonal);
        }
    // the source is vacuum: its capacity is the additional cost of sample
    for (std::size_t i = 0; i < terminal.size(); ++i)
        graph.addTermWeights(static_cast<int>(i), std::max(0.0, terminal[i]), std::max(0.0, -terminal[i]));
    graph.maxFlow();
    PixelMask cut = labels;
    for (long i = 0; i < labels.size(); ++i)
        if (const int v = vertex.data()[i]; v >= 0) cut.data()[i] = graph.inSourceSegment(v) ? 0 : 1;
    return cut;
}

/// Part of a grid of squares.
struct Tile {
    long row = 0, column = 0, rows = 0, columns = 0;
};

Tile widened(const Tile& tile, long margin, long rows, long columns) {
    const long top = std::max(0L, tile.row - margin), left = std::max(0L, tile.column - margin);
    return {top, left, std::min(rows, tile.row + tile.rows + margin) - top,
            std::min(columns, tile.column + tile.columns + margin) - left};
}

/// The differences of the free squares of one tile.
void weigh(std::vector<double>& difference, const Vertices& vertex, const Tile& tile, const FramePixels& pixels,
           const PixelMask& hidden, long side, const PixelMask& labels, const PixelMask& core) {
    const auto wide = widened(tile, surroundings, labels.rows(), labels.cols());
    const auto cells = cells_of(pixels, hidden, side, wide.row, wide.column, wide.rows, wide.columns);
    const PixelMask own_labels = labels.block(wide.row, wide.column, wide.rows, wide.columns),
                    own_core = core.block(wide.row, wide.column, wide.rows, wide.columns);
    const double origin = cells.mean.mean();
    const auto vacuum = around(cells.mean, cells.weight, own_core, 0, own_labels, origin),
               sample = around(cells.mean, cells.weight, own_core, 1, own_labels, origin);
    const double floor = 1e-6 * std::max(1e-300, (cells.mean - origin).square().mean());
    for (long row = tile.row; row < tile.row + tile.rows; ++row)
        for (long column = tile.column; column < tile.column + tile.columns; ++column) {
            const int at = vertex(row, column);
            const long y = row - wide.row, x = column - wide.column;
            if (at < 0 || cells.weight(y, x) == 0 || vacuum.count(y, x) < 10 || sample.count(y, x) < 10) continue;
            const double v = vacuum.variance(y, x) + floor, s = sample.variance(y, x) + floor;
            const double dv = cells.mean(y, x) - vacuum.mean(y, x), ds = cells.mean(y, x) - sample.mean(y, x);
            difference[static_cast<std::size_t>(at)] =
                std::clamp(0.5 * (ds * ds / s - dv * dv / v) + 0.5 * std::log(s / v), -max_difference, max_difference);
        }
}

}  // namespace

Cells cells_of(const FramePixels& pixels, const PixelMask& hidden, long side, long first_row, long first_column,
               long rows, long columns) {
    Cells cells{CellMap::Zero(rows, columns), CellMap::Zero(rows, columns), CellMap::Zero(rows, columns)};
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column) {
            const long top = (first_row + row) * side, left = (first_column + column) * side;
            double sum = 0, squares = 0, count = 0;
            const double origin = static_cast<double>(pixels(top, left));
            for (long y = top; y < top + side; ++y)
                for (long x = left; x < left + side; ++x) {
                    if (hidden(y, x) != 0) continue;
                    const double value = static_cast<double>(pixels(y, x)) - origin;
                    sum += value;
                    squares += value * value;
                    count += 1;
                }
            if (2 * count < static_cast<double>(side * side)) continue;
            cells.weight(row, column) = 1;
            cells.mean(row, column) = origin + sum / count;
            const double variance = count > 1 ? (squares - sum * sum / count) / (count - 1) : 0.0;
            cells.log_variance(row, column) =
                variance > 0 ? std::log(variance) : std::numeric_limits<double>::quiet_NaN();
        }
    // squares without scatter have the smallest nonzero scatter
    const double least =
        cells.log_variance.isFinite().select(cells.log_variance, std::numeric_limits<double>::infinity()).minCoeff();
    cells.log_variance = cells.log_variance.isFinite().select(cells.log_variance, std::isfinite(least) ? least : 0.0);
    return cells;
}

PixelMask minimum_cut(const CellMap& difference, double border_cost, const PixelMask& free, const PixelMask& labels) {
    std::vector<double> terminal;
    for (long i = 0; i < free.size(); ++i)
        if (free.data()[i] != 0) terminal.push_back(difference.data()[i]);
    return cut_of(numbered(free), std::move(terminal), border_cost, labels);
}

PixelMask cut_in_band(const FramePixels& pixels, const PixelMask& hidden, long side, const PixelMask& labels,
                      long width, double border_cost) {
    const PixelMask core = away_from_border(labels, 2);
    const PixelMask free = 1 - away_from_border(labels, width);
    const auto vertex = numbered(free);
    std::vector<double> difference(static_cast<std::size_t>((free != 0).count()), 0.0);
    for (long row = 0; row < labels.rows(); row += tile_side)
        for (long column = 0; column < labels.cols(); column += tile_side) {
            const Tile tile{row, column, std::min(tile_side, labels.rows() - row),
                            std::min(tile_side, labels.cols() - column)};
            if ((free.block(tile.row, tile.column, tile.rows, tile.columns) != 0).any())
                weigh(difference, vertex, tile, pixels, hidden, side, labels, core);
        }
    return cut_of(vertex, std::move(difference), border_cost, labels);
}

void remove_islands(PixelMask& sample, double min_area) {
    for (const int label : {1, 0}) {
        PixelMask own = (sample == static_cast<std::uint8_t>(label)).cast<std::uint8_t>();
        cv::Mat parts, statistics, centres;
        const int count = cv::connectedComponentsWithStats(view(own), parts, statistics, centres, 4, CV_32S);
        int largest = 0;
        for (int part = 1; part < count; ++part)
            if (largest == 0 ||
                statistics.at<int>(part, cv::CC_STAT_AREA) > statistics.at<int>(largest, cv::CC_STAT_AREA))
                largest = part;
        for (long row = 0; row < sample.rows(); ++row)
            for (long column = 0; column < sample.cols(); ++column) {
                const int part = parts.at<int>(static_cast<int>(row), static_cast<int>(column));
                if (part > 0 && part != largest && statistics.at<int>(part, cv::CC_STAT_AREA) < min_area)
                    sample(row, column) = static_cast<std::uint8_t>(1 - label);
            }
    }
}

}  // namespace setae::imaging
