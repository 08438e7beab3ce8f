// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "setae/core/constants.hpp"

namespace setae::contact {

/// A smooth function on [0, upper], interpolated at Chebyshev's points of the first kind.
class ChebyshevSeries {
public:
    /// values[i] of the function at point(i, values.size(), upper).
    ChebyshevSeries(const std::vector<double>& values, double upper) : upper_(upper), coefficients_(values.size()) {
        const auto n = static_cast<double>(values.size());
        for (std::size_t k = 0; k < values.size(); ++k) {
            double sum = 0.0;
            for (std::size_t i = 0; i < values.size(); ++i)
                sum += values[i] * std::cos(pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / n);
            coefficients_[k] = (k == 0 ? 1.0 : 2.0) / n * sum;
        }
    }

    [[nodiscard]] static double point(std::size_t i, std::size_t count, double upper) {
        return 0.5 * upper * (1.0 + std::cos(pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count)));
    }

    /// Clenshaw's recurrence.
    [[nodiscard]] double value(double x) const {
        const double t = 2.0 * x / upper_ - 1.0;
        double last = 0.0, before = 0.0;
        for (std::size_t k = coefficients_.size() - 1; k > 0; --k) {
            const double next = coefficients_[k] + 2.0 * t * last - before;
            before = last;
            last = next;
        }
        return coefficients_[0] + t * last - before;
    }

    /// The same with T_k' = k U_(k−1).
    [[nodiscard]] double derivative(double x) const {
        const double t = 2.0 * x / upper_ - 1.0;
        double last = 0.0, before = 0.0;
        for (std::size_t k = coefficients_.size() - 1; k > 0; --k) {
            const double next = static_cast<double>(k) * coefficients_[k] + 2.0 * t * last - before;
            before = last;
            last = next;
        }
        return 2.0 / upper_ * last;
    }

private:
    double upper_;
    std::vector<double> coefficients_;
};

}  // namespace setae::contact
