// SPDX-License-Identifier: GPL-3.0-or-later
#include "bulk_speeds.hpp"

#include <fmt/format.h>

#include "setae/contact/bulk_crack_factor.hpp"
#include "setae/core/uncertain_text.hpp"

namespace setae::study {

double ElastomerTimes::largest_bulk_factor() const {
    std::vector<contact::RelaxationTerm> terms;
    for (const auto& term : relaxation) terms.push_back({term.share.value, term.time.value});
    return contact::crack_speed::largest_bulk_factor(terms);
}

std::vector<Alert> speeds_beyond_bulk(const Hysteresis& hysteresis) {
    constexpr double standard_errors = 2.0;
    std::vector<Alert> alerts;
    for (const auto& elastomer : hysteresis.elastomers) {
        if (!elastomer.edge || elastomer.relaxation.empty()) continue;
        const double bound = elastomer.largest_bulk_factor();
        const auto& rest = elastomer.edge->law.rest_factor;
        const PairHysteresis* farthest = nullptr;
        Estimate at_speed;
        for (const auto& pair : hysteresis.pairs) {
            if (pair.elastomer != elastomer.elastomer || !pair.speed_factor) continue;
            const auto over_rest = setae::propagated([](const std::vector<double>& in) { return in[0] / in[1]; },
                                                     {*pair.speed_factor, rest})
                                       .estimate();
            if (over_rest.value - standard_errors * over_rest.standard_error > bound &&
                (!farthest || over_rest.value > at_speed.value)) {
                farthest = &pair;
                at_speed = over_rest;
            }
        }
        if (farthest)
            alerts.push_back(
                {"SPEED_BEYOND_BULK", elastomer.elastomer,
                 fmt::format(
                     "on {} the contact edge needs {} times the work at speed that it needs at rest, but the stated "
                     "relaxation of the bulk allows at most {:.3g} times",
                     farthest->surface, format_uncertain(at_speed, "1"), bound),
                 "measure the modulus at higher frequencies if fast terms of the relaxation are missing; if the "
                 "edge itself loses energy, use `relaxation` only for the bulk and take the speed dependence "
                 "from the references"});
    }
    return alerts;
}

}  // namespace setae::study
