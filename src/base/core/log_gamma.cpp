// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/log_gamma.hpp"

#include <cmath>
#include <limits>

#include <boost/math/special_functions/gamma.hpp>

namespace setae {

double log_gamma(double x) {
    if (x <= 0.0 && x == std::floor(x)) return std::numeric_limits<double>::infinity();
    return boost::math::lgamma(x);
}

}  // namespace setae
