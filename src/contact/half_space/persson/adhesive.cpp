// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/persson/adhesive.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/persson/stress_diffusion.hpp"

namespace setae::persson {
namespace {

constexpr double kept = 0.5;  ///< share of the last round's γ_eff: without it rounds may swing

/// γ_eff by the balance, from the shortest wave up.
Array1D balanced_work(const Array1D& area, double work_of_adhesion, const Scales& scales) {
    const Index n = area.size();
    Array1D work(n);
    const double gained = work_of_adhesion * area[n - 1];
    double stored = 0.0;
    for (Index i = n - 1; i >= 0; --i) {
        if (i + 1 < n)
            stored += 0.5 * (area[i] + area[i + 1]) * (scales.stored_energy[i + 1] - scales.stored_energy[i]);
        work[i] = area[i] > 0.0 ? std::max(0.0, gained - stored) / area[i] : 0.0;
    }
    return work;
}

void require(double pressure, double work_of_adhesion, const AdhesiveOptions& options) {
    if (!std::isfinite(pressure)) throw InvalidArgument(fmt::format("pressure is {} Pa; expected a number", pressure));
    if (!(work_of_adhesion >= 0.0) || !std::isfinite(work_of_adhesion))
        throw InvalidArgument(fmt::format("work of adhesion is {} J/m2; expected >= 0", work_of_adhesion));
    if (!(options.crack_factor > 0.0))
        throw InvalidArgument(fmt::format("crack factor is {}; expected > 0", options.crack_factor));
}

}  // namespace

AdhesiveContactAtScales adhesive_contact_at_scales(double pressure, double work_of_adhesion, const Scales& scales,
                                                   const AdhesiveOptions& options) {
    require(pressure, work_of_adhesion, options);
    const Index n = scales.wavevector.size();
    AdhesiveContactAtScales contact{.area_fraction = Array1D::Ones(n)};
    contact.effective_work = balanced_work(contact.area_fraction, work_of_adhesion, scales);
    while (!contact.converged && contact.rounds < options.max_rounds) {
        ++contact.rounds;
        contact.detachment_stress = (2.0 * options.crack_factor * scales.stiffness * contact.effective_work).sqrt();
        contact.area_fraction =
            stress_diffusion(scales.pressure_variance, contact.detachment_stress, pressure).area_fraction;
        const Array1D balanced = balanced_work(contact.area_fraction, work_of_adhesion, scales);
        contact.converged =
            (balanced - contact.effective_work).abs().maxCoeff() <= options.tolerance * work_of_adhesion;
        contact.effective_work = kept * contact.effective_work + (1.0 - kept) * balanced;
    }
    return contact;
}

}  // namespace setae::persson
