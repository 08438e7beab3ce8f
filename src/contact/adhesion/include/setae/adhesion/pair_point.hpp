// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/estimate.hpp"
#include "setae/core/traced_value.hpp"

namespace setae::adhesion {

/// What the names of noise that no two pairs share begin with.
inline constexpr const char* own_noise_of = "noise of ";

/// Name of the input that the own noise of a pair's measured quantity is: "noise of W_app on S × E".
[[nodiscard]] std::string own_noise_name(const std::string& quantity, const std::string& surface,
                                         const std::string& elastomer);

/// One surface × elastomer pair as a fit of the intrinsic work of adhesion W sees it.
///
///   prediction(W) = max(0, slope · W − offset)
///
/// Balance (7): slope r, offset γ1 (r − 1) + U_el/A.  (S13): slope 1 + h'²/2, offset U_el/A.  Loops (10): slope A_true,
/// offset 0, or minus the loss of the smooth sphere.
struct PairPoint {
    std::string surface;
    std::string elastomer;
    std::string quantity = "W_app";  ///< what was measured
    Estimate measured;               ///< its standard error is of noise and scatter, without what inputs add
    Components measured_inputs;      ///< inputs that it shares with others: radius of a lens, calibrations
    Components measured_noise;       ///< the part of its noise that other values know, too: E of the same fit
    double slope = 0.0;              ///< > 0
    double offset = 0.0;
    Components slope_inputs, offset_inputs;
    /// What a pair that was not measured departs from slope · W − offset by: departure_from().
    Components departure;
    bool floored = true;  ///< predictions stop at 0

    /// Variance of what no other value shares.
    [[nodiscard]] double own_variance() const;
    [[nodiscard]] double raw_prediction(double work) const { return slope * work - offset; }
    [[nodiscard]] double prediction(double work) const;
    /// Components of slope · W − offset, W exact.
    [[nodiscard]] Components prediction_inputs(double work) const;
    [[nodiscard]] double prediction_variance(double work) const;
    /// Names of the inputs that the pair's own noise is, and the scatter of all pairs' values between pairs, surfaces
    /// or elastomers.
    [[nodiscard]] std::string own_noise() const;
    [[nodiscard]] std::string scatter_between(const char* groups) const;
};

/// slope · W − offset with every input it rests on, `departure` among them.
[[nodiscard]] TracedValue raw_prediction(const PairPoint& pair, const TracedValue& work);

/// The pair's own noise as an input, times a derivative.
[[nodiscard]] Component own_noise(const PairPoint& pair, double derivative);

/// Components of measured − prediction(W), W exact and own noise left out. Relative errors of the measured value are
/// taken of the prediction: of the measured value itself, its noise would weigh pairs that came out small more.
[[nodiscard]] Components residual_inputs(const PairPoint& pair, double work);

/// Share of an error of slope · W − offset that the floor at 0 lets through: rectified_share() of its value and its
/// standard error, W exact.
[[nodiscard]] double share_through_floor(const PairPoint& pair, double work);
/// The same where prediction_variance() is known.
[[nodiscard]] double share_through_floor(const PairPoint& pair, double work, double prediction_variance);

/// What relative errors of a measured value are multiplied by, to be of the prediction.
[[nodiscard]] double predicted_over_measured(const PairPoint& pair, double work);

}  // namespace setae::adhesion
