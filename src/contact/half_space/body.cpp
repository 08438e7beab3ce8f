// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/body.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "setae/contact/layer.hpp"
#include "setae/core/errors.hpp"

namespace setae::half_space {
namespace {

double frictionless_ratio(double x) {
    if (x > 20.0) return 1.0;
    const double sinh = std::sinh(x);
    return (std::sinh(2.0 * x) + 2.0 * x) / (2.0 * sinh * sinh);
}

/// Stiffness of the whole layer, with constant widths [Pa/m].
double mean_stiffness(const Layer& layer, double contact_modulus) {
    const double nu = layer.poisson_ratio;
    if (nu == 0.5) return std::numeric_limits<double>::infinity();
    return contact_modulus * (1.0 - nu) * (1.0 - nu) / ((1.0 - 2.0 * nu) * layer.thickness);
}

}  // namespace

void require(const Body& body) {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!positive(body.contact_modulus))
        throw InvalidArgument(fmt::format("contact modulus must be > 0 and finite, got {} Pa", body.contact_modulus));
    if (!body.layer) return;
    if (!positive(body.layer->thickness))
        throw InvalidArgument(
            fmt::format("thickness of the layer must be > 0 and finite, got {} m", body.layer->thickness));
    if (!(body.layer->poisson_ratio > -1.0 && body.layer->poisson_ratio <= 0.5))
        throw InvalidArgument(
            fmt::format("Poisson ratio of the layer must lie in (-1, 1/2], got {}", body.layer->poisson_ratio));
}

double stiffness(double wavevector, const Body& body) {
    require(body);
    if (!(wavevector >= 0.0)) throw InvalidArgument(fmt::format("wavevector must be >= 0, got {}", wavevector));
    if (!body.layer) return 0.5 * body.contact_modulus * wavevector;
    if (wavevector == 0.0) return mean_stiffness(*body.layer, body.contact_modulus);
    const double x = wavevector * body.layer->thickness;
    const double ratio = body.layer->base == Base::bonded
                             ? contact::layer::stiffness_ratio(x, body.layer->poisson_ratio)
                             : frictionless_ratio(x);
    return 0.5 * body.contact_modulus * wavevector * ratio;
}

}  // namespace setae::half_space
