// SPDX-License-Identifier: GPL-3.0-or-later
#include "natural_spline.hpp"

namespace setae::spectral_fit {

NaturalSpline::NaturalSpline(const Array1D& positions, const Array1D& targets)
    : steps_(positions.tail(positions.size() - 1) - positions.head(positions.size() - 1)),
      diagonal_(positions.size()),
      factor_(positions.size()),
      interval_(targets.size()),
      left_(targets.size()),
      right_(targets.size()),
      left_bend_(targets.size()),
      right_bend_(targets.size()) {
    const Index last = positions.size() - 1;
    factor_[0] = 0.0;
    diagonal_[0] = 1.0;
    double above = 0.0;  // entry to the right of the diagonal in the previous row
    for (Index i = 1; i < last; ++i) {
        factor_[i] = i == 1 ? 0.0 : steps_[i - 1] / 6.0 / diagonal_[i - 1];
        diagonal_[i] = (steps_[i - 1] + steps_[i]) / 3.0 - factor_[i] * above;
        above = steps_[i] / 6.0;
    }
    Index i = 0;
    for (Index t = 0; t < targets.size(); ++t) {
        while (i + 1 < last && targets[t] > positions[i + 1]) ++i;
        const double step = steps_[i], right = (targets[t] - positions[i]) / step, left = 1.0 - right;
        interval_[t] = static_cast<int>(i);
        left_[t] = left;
        right_[t] = right;
        left_bend_[t] = (left * left * left - left) * step * step / 6.0;
        right_bend_[t] = (right * right * right - right) * step * step / 6.0;
    }
}

Array1D NaturalSpline::operator()(const Array1D& values) const {
    const Index last = values.size() - 1;
    Array1D bend = Array1D::Zero(values.size());
    for (Index i = 1; i < last; ++i)
        bend[i] = (values[i + 1] - values[i]) / steps_[i] - (values[i] - values[i - 1]) / steps_[i - 1] -
                  factor_[i] * bend[i - 1];
    for (Index i = last - 1; i >= 1; --i)
        bend[i] = (bend[i] - (i + 1 < last ? steps_[i] / 6.0 * bend[i + 1] : 0.0)) / diagonal_[i];
    Array1D result(interval_.size());
    for (Index t = 0; t < result.size(); ++t) {
        const Index i = interval_[t];
        result[t] =
            left_[t] * values[i] + right_[t] * values[i + 1] + left_bend_[t] * bend[i] + right_bend_[t] * bend[i + 1];
    }
    return result;
}

}  // namespace setae::spectral_fit
