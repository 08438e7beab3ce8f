// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::tests {

/// Numbers; null is undefined.
inline Array1D series(const nlohmann::json& values) {
    Array1D numbers(static_cast<Index>(values.size()));
    for (Index i = 0; i < numbers.size(); ++i) {
        const auto& value = values[static_cast<std::size_t>(i)];
        numbers[i] = value.is_null() ? undefined : value.get<double>();
    }
    return numbers;
}

inline Array2D matrix(const nlohmann::json& rows) {
    Array2D values(static_cast<Index>(rows.size()), static_cast<Index>(rows[0].size()));
    for (Index i = 0; i < values.rows(); ++i) values.row(i) = series(rows[static_cast<std::size_t>(i)]).transpose();
    return values;
}

/// Inputs and outputs of SurfaceTopography 1.27.1, and the measurements in them; skipped where the file is missing.
class AnalysisCases : public testing::Test {
protected:
    void SetUp() override {
        SETAE_REQUIRE_REFERENCE_DATA(path, "expected/analysis_cases.json");
        cases = nlohmann::json::parse(std::ifstream(path));
    }
    [[nodiscard]] topography::LineScan line_scan(const char* name) const {
        const auto& input = cases[name]["input"];
        return {series(input["heights"]), input["physical_size"], input["periodic"], {}};
    }
    [[nodiscard]] topography::HeightMap height_map(const char* name) const {
        const auto& input = cases[name]["input"];
        return {
            matrix(input["heights"]), {input["physical_sizes"][0], input["physical_sizes"][1]}, input["periodic"], {}};
    }
    /// The map that is not periodic, with its holes.
    [[nodiscard]] topography::HeightMap masked_map() const {
        auto map = height_map("map_nonperiodic");
        for (const auto& place : cases["map_masked"]["mask_true_indices"])
            map.heights(place[0].get<Index>(), place[1].get<Index>()) = undefined;
        return map;
    }
    [[nodiscard]] topography::Profile polyline() const {
        const auto& input = cases["nonuniform"]["input"];
        return {series(input["x"]), series(input["h"]), {}};
    }

    nlohmann::json cases;
};

}  // namespace setae::tests
