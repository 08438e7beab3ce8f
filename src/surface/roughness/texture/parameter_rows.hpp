// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "filtered.hpp"

namespace setae::texture {

/// Whether at least one of these symbols is requested, or all are.
[[nodiscard]] bool is_requested(const std::vector<std::string>& only, std::initializer_list<std::string_view> symbols);

/// List of parameters in preparation, each with its entry in the table and the common properties.
class ParameterRows {
public:
    /// only: symbols of the table that are added; empty: all.
    ParameterRows(Standard standard, std::string filter, Bandwidth bandwidth, std::vector<Alert> alerts, Index points,
                  std::vector<std::string> only, char letter = 0);

    /// symbol: as in the table; one that is not requested adds nothing. A row with value NaN and no warning gets
    /// UNDEFINED.
    void add(std::string_view symbol, Estimate estimate, std::vector<Alert> alerts = {});

    [[nodiscard]] std::vector<TextureParameter> take() { return std::move(rows_); }

private:
    Standard standard_;
    std::string filter_;
    Bandwidth bandwidth_;
    std::vector<Alert> alerts_;
    Index points_;
    std::vector<std::string> only_;
    char letter_;  ///< replaces the first letter, or 0
    std::vector<TextureParameter> rows_;
};

}  // namespace setae::texture
