// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/fourier/transform.hpp"

namespace setae::processing {

/// Slopes per step at the points of lines of n heights, NaN = undefined.
///
/// Periodic complete lines: the Fourier derivative without the Nyquist mode. Others: central differences; at ends and
/// next to undefined points one-sided differences with two neighbours (exact for parabolas) or one, or 0.
class LineSlopes {
public:
    LineSlopes(Index points, bool periodic);
    /// Any number of threads may call it simultaneously.
    void find(const double* heights, double* slopes) const;

private:
    Index points_;
    bool periodic_;
    std::optional<fourier::RealTransform> forward_;
    std::optional<fourier::InverseRealTransform> back_;
};

}  // namespace setae::processing
