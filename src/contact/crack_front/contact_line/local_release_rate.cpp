// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact_line/local_release_rate.hpp"

#include <fmt/format.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"

namespace setae::contact_line {

Array2D local_release_rate(const ContactLine& line, const ArrayView1D& displacement,
                           const contact::SphereOnFlat& sphere, Index largest_mode) {
    require_valid(line);
    if (displacement.size() != line.frames())
        throw InvalidArgument(
            fmt::format("{} displacements for {} frames; expected one per frame", displacement.size(), line.frames()));
    const Index n = line.angles(), last = largest_mode > 0 ? std::min(largest_mode, n / 2) : n / 2;
    const fourier::RealTransform forward(n);
    const fourier::InverseRealTransform inverse(n);
    fourier::Buffer<double> bend(static_cast<std::size_t>(n));
    fourier::Buffer<fourier::Complex> modes(static_cast<std::size_t>(forward.modes()));
    Array2D rate(line.frames(), n);
    for (Index i = 0; i < line.frames(); ++i) {
        for (Index j = 0; j < n; ++j) bend[static_cast<std::size_t>(j)] = line.radius(i, j);
        forward.forward(bend.data(), modes.data());
        const double scale = 1.0 / modes[0].real();  // N r̄, which the transforms' N cancels
        for (Index k = 0; k < forward.modes(); ++k)
            modes[static_cast<std::size_t>(k)] *= k <= last ? static_cast<double>(k) * scale : 0.0;
        inverse.apply(modes.data(), bend.data());
        for (Index j = 0; j < n; ++j)
            rate(i, j) = contact::jkr::energy_release_rate_at_displacement(line.radius(i, j), displacement[i], sphere) *
                         (1.0 + bend[static_cast<std::size_t>(j)]);
    }
    return rate;
}

}  // namespace setae::contact_line
