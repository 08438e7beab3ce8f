// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/force_drift.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

using Named = std::pair<DriftModel, const char*>;
constexpr std::array<Named, 6> models{
    Named{DriftModel::automatic, "auto"}, Named{DriftModel::constant, "none"},
    Named{DriftModel::linear, "linear"},  Named{DriftModel::quadratic, "quadratic"},
    Named{DriftModel::cubic, "cubic"},    Named{DriftModel::extrapolated, "extrapolate"}};

}  // namespace

std::string to_string(DriftModel model) {
    for (const auto& [value, name] : models)
        if (value == model) return name;
    throw InternalError("unknown model of drift");
}

DriftModel drift_model_named(std::string_view name) {
    std::string names;
    for (const auto& [value, word] : models) {
        if (name == word) return value;
        names += names.empty() ? word : fmt::format(", {}", word);
    }
    throw InvalidArgument(fmt::format("drift '{}' is unknown; expected one of {}", name, names));
}

}  // namespace setae::loops
