// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/statistics/equivalence.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::statistics {

Equivalence test_equivalence(const Estimate& difference, double margin, double significance) {
    if (!(margin > 0.0)) throw InvalidArgument(fmt::format("a margin of {}; expected more than 0", margin));
    if (!(significance > 0.0 && significance < 0.5))
        throw InvalidArgument(
            fmt::format("a significance of {}; expected more than 0 and less than 0.5", significance));
    Equivalence test{.difference = difference, .margin = margin};
    if (!difference.uncertain()) return test;
    const double freedom = difference.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity());
    const auto beyond = [&](double distance) {
        return student_t_probability(-distance / difference.standard_error, freedom);
    };
    test.probability = std::max(beyond(margin + difference.value), beyond(margin - difference.value));
    const double reach = student_t_quantile(1.0 - significance, freedom) * difference.standard_error;
    test.interval = {difference.value - reach, difference.value + reach, 1.0 - 2.0 * significance};
    if (test.probability < significance) test.verdict = Verdict::equivalent;
    else if (test.interval->lower > margin || test.interval->upper < -margin) test.verdict = Verdict::different;
    return test;
}

const char* name(Verdict verdict) {
    switch (verdict) {
        case Verdict::equivalent: return "equivalent";
        case Verdict::different: return "different";
        case Verdict::undecided: break;
    }
    return "undecided";
}

}  // namespace setae::statistics
