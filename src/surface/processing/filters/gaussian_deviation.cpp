// SPDX-License-Identifier: GPL-3.0-or-later
#include "gaussian_deviation.hpp"

#include <cmath>
#include <numbers>

namespace setae::processing {

double gaussian_deviation(double cutoff, Index order) {
    const double exponent = order < 2 ? std::numbers::ln2 : 1.6783469900166605;
    return cutoff * std::sqrt(0.5 * exponent) / std::numbers::pi;
}

}  // namespace setae::processing
