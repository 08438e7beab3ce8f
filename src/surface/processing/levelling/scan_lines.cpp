// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_lines.hpp"

#include <algorithm>

namespace setae::processing {
namespace {

constexpr Index lines_per_band = 16;  // two cache lines of each row if lines run along x

/// Calls copy(offset in the map, offset in the band) for every point of the lines [first, last).
template <class Copy>
void for_each_point(const Array2D& heights, Direction direction, const LineBand& band, Index first, Index last,
                    const Copy& copy) {
    const Index columns = heights.cols();
    if (direction == Direction::y) {
        for (Index line = first; line < last; ++line)
            for (Index k = 0; k < band.points; ++k) copy(line * columns + k, (line - band.first) * band.points + k);
        return;
    }
    for (Index k = 0; k < band.points; ++k)
        for (Index line = first; line < last; ++line) copy(k * columns + line, (line - band.first) * band.points + k);
}

}  // namespace

Index line_count(const Array2D& heights, Direction direction) {
    return direction == Direction::x ? heights.cols() : heights.rows();
}
Index points_on_line(const Array2D& heights, Direction direction) {
    return direction == Direction::x ? heights.rows() : heights.cols();
}

void for_each_band(Array2D& heights, const topography::Mask& chosen, Direction direction, Index before, bool write,
                   parallel::Threads threads, const std::function<void(LineBand&, Index, Index)>& body) {
    const Index lines = line_count(heights, direction);
    parallel::for_each_index(static_cast<std::size_t>((lines + lines_per_band - 1) / lines_per_band), threads,
                             [&](std::size_t number) {
                                 const Index first = static_cast<Index>(number) * lines_per_band,
                                             last = std::min(lines, first + lines_per_band);
                                 LineBand band;
                                 band.first = std::max<Index>(0, first - before);
                                 band.count = last - band.first;
                                 band.points = points_on_line(heights, direction);
                                 band.heights.resize(static_cast<std::size_t>(band.count * band.points));
                                 if (chosen.size() > 0) band.chosen.resize(band.heights.size());
                                 for_each_point(heights, direction, band, band.first, last, [&](Index from, Index to) {
                                     band.heights[static_cast<std::size_t>(to)] = heights.data()[from];
                                     if (!band.chosen.empty())
                                         band.chosen[static_cast<std::size_t>(to)] = chosen.data()[from];
                                 });
                                 body(band, first, last);
                                 if (write)
                                     for_each_point(heights, direction, band, first, last, [&](Index to, Index from) {
                                         heights.data()[to] = band.heights[static_cast<std::size_t>(from)];
                                     });
                             });
}

}  // namespace setae::processing
