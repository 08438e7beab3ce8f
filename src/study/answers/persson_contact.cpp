// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/persson_contact.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/answers/pressures.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::answers {

void PerssonRequest::require_complete() const {
    (void)body();
    if (pressure.empty()) throw InvalidArgument("no pressure; expected `pressure = 10 MPa`");
}

persson::LoadOptions PerssonRequest::options() const {
    persson::LoadOptions options{.energy_factor = energy_factor};
    if (!work_of_adhesion.empty())
        options.work_of_adhesion = parse_quantity(work_of_adhesion, non_negative(dimension::surface_energy));
    return options;
}

study::SurfaceResult surface_for_theory(const study::SurfaceInput& input, study::SurfaceAnalysisOptions analysis,
                                        parallel::Threads threads, bool every_measurement) {
    analysis.bootstrap_resamples = 0;
    return study::analyse_surface(input, analysis,
                                  {.previews = false, .parameters = false, .every_measurement = every_measurement},
                                  threads)
        .surface;
}

PerssonContact persson_contact(const study::SurfaceResult& surface, const PerssonRequest& request) {
    request.require_complete();
    const auto body = request.body();
    const auto pressures = pressures_of(request.pressure);
    const auto options = request.options();
    PerssonContact contact{.scales = persson::scales_of(surface.used().curve, body),
                           .load = {},
                           .along_scales = {},
                           .contact_modulus = body.contact_modulus,
                           .energy_factor = request.energy_factor,
                           .alerts = alerts_of(surface)};
    contact.load = persson::load_table(pressures, contact.scales, options);
    if (pressures.size() == 1) contact.along_scales = persson::scale_table(pressures[0], contact.scales, options);
    return contact;
}

}  // namespace setae::answers
