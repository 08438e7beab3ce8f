// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/fourier/transform.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::processing {

/// @throws InvalidArgument with the alternative for data that are not periodic, UndefinedDataError for undefined
/// heights.
void require_periodic(bool periodic, bool complete, const char* what, const topography::Metadata& metadata);

/// Lines of n points through their Fourier series on N points (fourier_interpolated).
class FourierLine {
public:
    FourierLine(Index points, Index new_points);
    /// Any number of threads may call it simultaneously.
    void resample(const double* heights, double* resampled) const;

private:
    fourier::RealTransform forward_;
    fourier::InverseRealTransform back_;
};

}  // namespace setae::processing
