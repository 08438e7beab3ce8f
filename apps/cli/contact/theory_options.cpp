// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/theory_options.hpp"

#include <string>

#include "setae/answers/pressures.hpp"
#include "setae/core/units.hpp"

namespace setae::cli {

void add_theory_options(Options& options, answers::PerssonRequest& request, const char* pressures) {
    options.add("--contact-modulus", request.modulus, "E* = E/(1 - nu^2) of the soft body")
        .quantity(positive(dimension::pressure));
    options
        .add("--pressure", request.pressure,
             std::string("mean pressure: one, several as 1MPa,10MPa, or ten a decade as 1MPa:100MPa") + pressures)
        .read_by([](const std::string& text) { (void)answers::pressures_of(text); });
    options.add("--layer", request.layer, "thickness of the soft body on a rigid base; default a half-space")
        .quantity(positive(dimension::length));
    options.add("--nu,--poisson-ratio", request.poisson_ratio, "of the layer").within(domain::poisson_ratio);
    options.flag("--frictionless", request.frictionless, "the layer slides on its base; default bonded");
    options.add("--energy-factor", request.energy_factor, "of the stored energy of partial contact, in (0, 1]")
        .within(domain::positive)
        .default_shown();
}

}  // namespace setae::cli
