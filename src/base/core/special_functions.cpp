// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/special_functions.hpp"

#include <cmath>
#include <numbers>

namespace setae {

double scaled_complementary_error_function(double x) {
    if (x < 0.0) return 2.0 * std::exp(x * x) - scaled_complementary_error_function(-x);
    // exp(x²) magnifies the rounding of x² by x²: below 2 the error is less than 1e-15
    if (x < 2.0) return std::exp(x * x) * std::erfc(x);
    // DLMF 7.9.3 from its tail: sqrt(pi) erfcx(x) = 1/(x + (1/2)/(x + (2/2)/(x + (3/2)/(x + …
    double tail = x;
    for (int k = 160; k >= 1; --k) tail = x + 0.5 * k / tail;
    return std::numbers::inv_sqrtpi / tail;
}

}  // namespace setae
