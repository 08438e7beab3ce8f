// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/pair_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/core/rectified.hpp"

namespace setae::adhesion {

std::string own_noise_name(const std::string& quantity, const std::string& surface, const std::string& elastomer) {
    return fmt::format("{}{} on {} × {}", own_noise_of, quantity, surface, elastomer);
}

double PairPoint::own_variance() const {
    return std::max(0.0, measured.variance() - covariance(measured_noise, measured_noise));
}

double PairPoint::prediction(double work) const {
    const double raw = raw_prediction(work);
    return floored ? std::max(0.0, raw) : raw;
}

Components PairPoint::prediction_inputs(double work) const {
    return combined({{work, slope_inputs}, {-1.0, offset_inputs}});
}

double PairPoint::prediction_variance(double work) const {
    const auto inputs = prediction_inputs(work);
    return covariance(inputs, inputs);
}

std::string PairPoint::own_noise() const { return own_noise_name(quantity, surface, elastomer); }

std::string PairPoint::scatter_between(const char* groups) const {
    return fmt::format("scatter of {} between {}", quantity, groups);
}

TracedValue raw_prediction(const PairPoint& pair, const TracedValue& work) {
    return {
        pair.raw_prediction(work.value),
        combined({{1.0, pair.prediction_inputs(work.value)}, {pair.slope, work.components}, {1.0, pair.departure}})};
}

Component own_noise(const PairPoint& pair, double derivative) {
    return {Array1D::Constant(1, derivative * std::sqrt(pair.own_variance())),
            pair.measured.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity())};
}

Components residual_inputs(const PairPoint& pair, double work) {
    return combined({{predicted_over_measured(pair, work), pair.in_unitputs},
                     {1.0, pair.measured_noise},
                     {-share_through_floor(pair, work), pair.prediction_inputs(work)}});
}

double predicted_over_measured(const PairPoint& pair, double work) {
    return pair.measured.value > 0.0 ? pair.prediction(work) / pair.measured.value : 1.0;
}

double share_through_floor(const PairPoint& pair, double work) {
    return pair.floored ? share_through_floor(pair, work, pair.prediction_variance(work)) : 1.0;
}

double share_through_floor(const PairPoint& pair, double work, double prediction_variance) {
    if (!pair.floored) return 1.0;
    return rectified_share(pair.raw_prediction(work), std::sqrt(prediction_variance));
}

}  // namespace setae::adhesion
