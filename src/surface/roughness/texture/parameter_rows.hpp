// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "filtered.hpp"

namespace setae::texture {

/// Whether some of these symbols are among those wanted, or no choice was made.
[[nodiscard]] bool wants(const std::vector<std::string>& only, std::initializer_list<std::string_view> symbols);

/// Values of parameters on their way into a list, each with what the table says of it and what all share.
class ParameterRows {
public:
    /// only: symbols of the table that are taken; empty: all.
    ParameterRows(Standard standard, std::string filter, Bandwidth bandwidth, std::vector<Alert> alerts, Index points,
                  std::vector<std::string> only, char letter = 0);

    /// symbol: as in the table; one that is not wanted adds nothing. A row whose value is NaN without an alert of its
    /// own gets UNDEFINED.
    void add(std::string_view symbol, Estimate estimate, std::vector<Alert> alerts = {});

    [[nodiscard]] std::vector<TextureParameter> take() { return std::move(rows_); }

private:
    Standard standard_;
    std::string filter_;
    Bandwidth bandwidth_;
    std::vector<Alert> alerts_;
    Index points_;
    std::vector<std::string> only_;
    char letter_;  ///< that takes the place of the first one, or 0
    std::vector<TextureParameter> rows_;
};

}  // namespace setae::texture
