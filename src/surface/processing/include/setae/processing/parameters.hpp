// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace setae::processing {

/// A name in pipeline files and its value.
template <class Value>
struct Choice {
    std::string_view name;
    Value value;
};

/// The parameters of a step: files, command line, documents and records are generated from them.
///
/// Every step is accompanied by
///     inline constexpr std::string_view step_name(const GaussianFilter&) { return "gaussian_filter"; }
///     template <class Visitor> void visit_parameters(GaussianFilter& step, Visitor& visitor) {
///         visitor.length("cutoff", step.cutoff, "nesting index λc");
///         visitor.choice("keep", step.keep, kept_names, "which part stays");
///     }
/// A visitor has, each with (name, value&, meaning): length (double [m]), optional_length (std::optional<double> [m]),
/// number (double without unit), angle (double [rad]), count (Index), flag (bool), text (std::string), region (Region),
/// and choice(name, value&, std::array of Choice, meaning). A parameter at its default may be missing in a file.

}  // namespace setae::processing
