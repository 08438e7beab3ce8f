// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "elements.hpp"

namespace setae::texture {

/// Sums over elements for a material ratio curve, at the heights h_k of the locator.
struct CurveSums {
    Array1D whole;         ///< weight of the elements entirely at or above h_k
    Array1D above;         ///< weight of all parts at or above h_k
    Array1D volume;        ///< ∫ max(z − h_k, 0); empty if not requested
    double weight = 0.0;   ///< of all elements
    double moment = 0.0;   ///< ∫ (z − h_0), if volumes are requested
    double lowest = 0.0;   ///< corner
    double highest = 0.0;  ///< corner
};

enum class Volumes { no, yes };

/// One pass. @throws UndefinedDataError if no element is defined.
[[nodiscard]] CurveSums sum_curve(const Elements& elements, const HeightLocator& locate, Volumes volumes,
                                  parallel::Threads threads);

/// The exact material ratio inside intervals h_j … h_{j+1} of the heights of the locator: elements with a corner inside
/// are stored, the others summed as one parabola.
class Brackets {
public:
    /// intervals: j, increasing, each once. whole: CurveSums::whole. One pass.
    Brackets(const Elements& elements, const HeightLocator& locate, const CurveSums& sums,
             std::span<const Index> intervals, parallel::Threads threads);

    /// P(height), h_j <= height < h_{j+1}; place: position of j among the intervals.
    [[nodiscard]] double ratio(std::size_t place, double height) const;

    struct Parabola {
        double constant = 0.0, linear = 0.0, square = 0.0;  ///< in height − h_j
    };
    struct Interval {
        double start = 0.0;
        Parabola parabola;
        std::vector<Triangle> triangles;
        std::vector<Segment> segments;
    };

private:
    std::vector<Interval> intervals_;
    double weight_;
};

/// H(p) as heights_at_ratio() of material_ratio.hpp, from existing sums at heights over the whole range. One pass.
/// @throws InvalidArgument for a ratio outside 0 … 1.
[[nodiscard]] Array1D heights_at_ratio(const Elements& elements, const HeightLocator& locate, const CurveSums& sums,
                                       const ArrayView1D& ratios, parallel::Threads threads);

/// Share of a triangle or segment at or above a height.
[[nodiscard]] double share_above(const Triangle& triangle, double height);
[[nodiscard]] double share_above(const Segment& segment, double height);

}  // namespace setae::texture
