// SPDX-License-Identifier: GPL-3.0-or-later
// Fits Hertz's paraboloid to the approach of a force curve and prints one line of JSON, for nanite.py to compare.
//   fit_force_curve FILE RADIUS POISSON_RATIO SPRING_CONSTANT|- SENSITIVITY|- CONTACT_SAMPLE|free LARGEST_SHARE
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "setae/loops/force_curve_fit.hpp"
#include "setae/tables/force_curve.hpp"

int main(int count, char** words) try {
    const std::vector<std::string> arguments(words + 1, words + count);
    if (arguments.size() != 7) {
        fmt::print(stderr,
                   "wants FILE RADIUS POISSON_RATIO SPRING_CONSTANT SENSITIVITY CONTACT_SAMPLE LARGEST_SHARE\n");
        return 2;
    }
    const auto optional = [](const std::string& word) {
        return word == "-" ? std::optional<double>() : std::stod(word);
    };
    const setae::Table curve = setae::tables::read_force_curve(
        arguments[0], {.spring_constant = optional(arguments[3]), .sensitivity = optional(arguments[4])});
    setae::loops::ForceCurveFitOptions options{.fit_force_offset = true, .subtract_baseline_slope = false};
    const auto segment = setae::loops::segments_of_curve(curve, options).front();
    if (arguments[5] != "free") {
        options.contact_point = segment.displacement[std::stol(arguments[5])];
        options.fit_contact_point = false;
    }
    options.range = {.from = -std::numeric_limits<double>::infinity(), .to = std::stod(arguments[6])};
    const setae::loops::LensAndCounterBody bodies{.radius = std::stod(arguments[1]),
                                                  .lens_poisson_ratio = std::stod(arguments[2]),
                                                  .counter_youngs_modulus = std::numeric_limits<double>::infinity()};
    const auto fit = setae::loops::fit_force_curve(segment, bodies, options);
    fmt::print(
        R"({{"youngs_modulus": {:.9g}, "standard_error": {:.3g}, "contact_point": {:.9g}, "first_displacement": {:.9g}, )"
        R"("force_offset": {:.6g}, "n": {}, "samples": {}, "rms": {:.6g}, "indentation": {:.6g}}})"
        "\n",
        fit.youngs_modulus.value, fit.youngs_modulus.standard_error, fit.contact_point.value, segment.displacement[0],
        fit.force_offset.value, fit.n, segment.force.size(), fit.rms_residual, fit.indentation_to);
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
}
