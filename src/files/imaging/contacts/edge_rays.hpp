// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "edge_ellipse.hpp"

namespace setae::imaging {

/// The edge along one ray: a sector of the annulus around the outline.
struct EdgeRay {
    double angle = 0;      ///< polar [rad]
    bool visible = false;  ///< enough of its sector is in the frame
    bool fitted = false;   ///< level, contrast and place have values
    double place = 0;      ///< distance from the outline along its normal [px]
    double contrast = 0, contrast_deviation = 0;
    double variance = 0;  ///< of place [px²]
};

/// All rays of a converged outline.
struct EdgeFit {
    Outline outline;
    OutlineShape shape = OutlineShape::ellipse;
    Eigen::Matrix<double, 5, 5> covariance = Eigen::Matrix<double, 5, 5>::Zero();
    std::vector<EdgeRay> rays;
    double edge_width = 0;      ///< w of erf(d/(√2 w)) [px]
    double contrast = 0;        ///< median of agreeing rays
    double noise = 0;           ///< standard deviation of a pixel about the fits
    double visible_share = 0;   ///< of the outline, within the frame
    double agreeing_share = 0;  ///< of the visible rays
    double significance = 0;    ///< median contrast of a ray over its standard deviation
    std::string failure;        ///< why there is no edge; empty if there is one
};

/// Share of an outline inside a frame.
[[nodiscard]] double share_within(const Outline& outline, long width, long height);

/// Fits the edge around an outline a few pixels away: level, contrast and place along each ray from the pixels of its
/// sector, one width for all from the mean profile, the outline from the places; repeated until convergence.
///
/// sign: +1 if the outside is brighter. uncertainty: possible distance of the outline from the edge [px]. With fringes
/// the rays end at twice the distance at which the mean profile first turns back outside the edge, at least at 3 px.
[[nodiscard]] EdgeFit fit_edge(const FramePixels& pixels, const Outline& outline, double sign, double uncertainty,
                               bool fringes);

}  // namespace setae::imaging
