// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "program/options.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/texture/profile_parameters.hpp"

namespace setae::cli {

/// Options of `setae params --standard`: which parameters, behind which filters, written how.
struct TextureOptions {
    std::string standard, s_filter, l_filter, section_length, kind, averages, mean_line, between, format,
        material_height;
    std::optional<double> material_ratio;

    void add_to(Options& options);

    /// Whether a standard's parameters are asked for.
    /// @throws InvalidArgument where only options of them are given.
    [[nodiscard]] bool asked() const;

    /// Parameters of one measurement; of a map by ISO 21920-2 the mean over its scan lines, with the standard error of
    /// their spread.
    [[nodiscard]] std::vector<texture::TextureParameter> parameters_of(const topography::Measurement& measurement,
                                                                       parallel::Threads threads) const;

private:
    [[nodiscard]] texture::Filters filters() const;
    [[nodiscard]] texture::ProfileOptions profile() const;
};

}  // namespace setae::cli
