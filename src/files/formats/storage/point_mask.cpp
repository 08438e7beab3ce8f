// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_mask.hpp"

#include <utility>

#include "channel_building.hpp"
#include "raster.hpp"
#include "setae/core/constants.hpp"

namespace setae::formats {
namespace {

void undefine(Array2D& heights, const PointMask& mask) {
    const Index nx = heights.rows(), ny = heights.cols();
    for (Index j = 0; j < ny; ++j) {
        const auto row = mask.source.bytes(mask.offset + static_cast<std::uint64_t>(j) * mask.row_distance,
                                           static_cast<std::uint64_t>(nx));
        for (Index i = 0; i < nx; ++i)
            if ((static_cast<unsigned char>(row[static_cast<std::size_t>(i)]) & mask.bits) != mask.defined)
                heights(i, j) = undefined;
    }
}

}  // namespace

Channel masked(Channel channel, const PointMask& mask) {
    require_raster({.offset = mask.offset,
                    .nx = channel.info.shape.at(0),
                    .ny = channel.info.shape.at(1),
                    .sample = Sample::uint8,
                    .line_distance = mask.row_distance},
                   mask.source, channel.info.format);
    read_as_a_whole(channel, [heights_of = channel.read, mask] {
        auto map = std::get<topography::HeightMap>(heights_of());
        undefine(map.heights, mask);
        return checked(std::move(map), mask.source);
    });
    return channel;
}

}  // namespace setae::formats
