// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/profile_likelihood.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {

ErrorEllipse error_ellipse(const JkrFit& fit, double level) {
    if (!(level > 0.0 && level < 1.0))
        throw InvalidArgument(fmt::format("the level of an error ellipse must lie between 0 and 1, got {}", level));
    if (fit.covariance.rows() < 2 || !fit.covariance.topLeftCorner<2, 2>().allFinite() ||
        !(std::abs(fit.correlation) < 1.0))
        throw UndefinedDataError(
            fmt::format("{}: no error ellipse, the fit has no covariance of E* and W", fit.method));
    const double freedom = fit.contact_modulus.degrees_of_freedom.value_or(INFINITY);
    const double squared =
        std::isfinite(freedom) ? freedom * std::expm1(-2.0 / freedom * std::log1p(-level)) : -2.0 * std::log1p(-level);
    constexpr Index points = 121;
    const Array1D angle = Array1D::LinSpaced(points, 0.0, 2.0 * pi);
    // the Cholesky factor of the covariance turns the unit circle into the ellipse
    const double modulus = std::sqrt(squared * fit.covariance(0, 0)), work = std::sqrt(squared * fit.covariance(1, 1));
    const double across = std::sqrt(1.0 - fit.correlation * fit.correlation);
    ErrorEllipse ellipse{.level = level};
    ellipse.contact_modulus = fit.contact_modulus.value + modulus * angle.cos();
    ellipse.work_of_adhesion =
        fit.work_of_adhesion.value + work * (fit.correlation * angle.cos() + across * angle.sin());
    return ellipse;
}

}  // namespace setae::loops
