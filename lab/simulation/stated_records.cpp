// SPDX-License-Identifier: GPL-3.0-or-later
#include "stated_records.hpp"

namespace setae::simulation {
namespace {

double value_of(const std::optional<StatedQuantity>& factor) { return factor ? factor->value : 1.0; }

}  // namespace

topography::LineScan stated(topography::LineScan scan, const InstrumentCalibration& factors) {
    scan.heights /= value_of(factors.height);
    scan.size /= value_of(factors.lateral);
    return scan;
}

topography::HeightMap stated(topography::HeightMap map, const InstrumentCalibration& factors) {
    map.heights /= value_of(factors.height);
    for (double& size : map.size) size /= value_of(factors.lateral);
    return map;
}

topography::Profile stated(topography::Profile contour, const InstrumentCalibration& factors) {
    contour.heights /= value_of(factors.height);
    contour.positions /= value_of(factors.lateral);
    return contour;
}

loops::Loop stated(loops::Loop loop, const Calibrations& factors) {
    loop.force /= value_of(factors.force);
    loop.displacement /= value_of(factors.displacement);
    loop.contact_radius /= value_of(factors.contact_radius);
    return loop;
}

}  // namespace setae::simulation
