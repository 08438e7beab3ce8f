// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "curve_sums.hpp"

namespace setae::texture {

/// A material ratio curve between nodes: parabolas that keep the exact ratios at the nodes and the exact volume between
/// them. Heights are relative to the mean.
class CurveInterpolant {
public:
    /// Nodes are added if the ratio decreases by more than 1/1024 between neighbours: two or three passes over the
    /// measurement.
    CurveInterpolant(const Elements& elements, parallel::Threads threads);

    /// Nodes as heights of the measurement, and the sums at them.
    [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }
    [[nodiscard]] const CurveSums& sums() const { return sums_; }

    [[nodiscard]] double lowest() const { return heights_.front(); }
    [[nodiscard]] double highest() const { return heights_.back(); }

    /// P(h).
    [[nodiscard]] double ratio(double height) const;
    /// H(p).
    [[nodiscard]] double height(double ratio) const;
    /// ∫_h^∞ P dh'.
    [[nodiscard]] double volume(double height) const;
    /// ∫_−∞^h (1 − P) dh' = volume(h) + h, with heights relative to the mean.
    [[nodiscard]] double void_volume(double height) const;
    /// ∫_h^∞ P² dh'.
    [[nodiscard]] double square(double height) const;

private:
    [[nodiscard]] std::size_t interval_of(double height) const;
    /// ∫_s^1 of P or P² over an interval, in units of its width.
    [[nodiscard]] double ratio_in(std::size_t interval, double s) const;

    std::vector<double> nodes_;
    CurveSums sums_;
    std::vector<double> heights_, ratios_, volumes_, squares_;
    std::vector<double> bulge_;  ///< P(s) = (1 − s) P_k + s P_{k+1} + bulge s (1 − s)
};

}  // namespace setae::texture
