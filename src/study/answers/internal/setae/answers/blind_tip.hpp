// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/core/units.hpp"
#include "setae/fields/option.hpp"
#include "setae/output/json.hpp"
#include "setae/topography/blind_tip.hpp"
#include "setae/topography/certainty.hpp"

namespace setae::answers {

/// Request of `setae tip` for a map.
struct BlindTipRequest {
    std::string threshold;
    Index points = 21;
    int rounds = 100;

    /// @throws InvalidArgument for a malformed length.
    [[nodiscard]] topography::BlindTipOptions options(parallel::Threads threads = {}) const;
};

/// The bluntest tip that is compatible with a map, and the resulting certainty of the surface.
struct BlindTipAnswer {
    std::string file;
    topography::BlindTip blind;
    topography::HeightMap tip;      ///< apex up
    topography::HeightMap surface;  ///< where it is certain, undefined elsewhere
    std::vector<Quantity> quantities;
    std::vector<Alert> alerts;
};

/// @throws InvalidArgument for a line; as topography::blind_tip() and certainty_map().
[[nodiscard]] BlindTipAnswer blind_tip(const std::string& file, const topography::Measurement& measurement,
                                       const BlindTipRequest& request, parallel::Threads threads = {});

/// "file", "rounds", "converged", "quantities", "tip" and "alerts".
[[nodiscard]] output::Json to_json(const BlindTipAnswer& answer);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::BlindTipRequest> {
    using R = answers::BlindTipRequest;
    static constexpr std::array options{
        option<&R::points>("points", "extent of the estimated tip in pixels, an odd number").default_shown(),
        option<&R::threshold>("threshold", "height by which the map must demand a sharper tip, about twice the noise")
            .of(non_negative(dimension::length))
            .such_as("0.2 nm")
            .or_else("0"),
        option<&R::rounds>("rounds", "largest number of passes over the map").default_shown().advanced(),
    };
};
