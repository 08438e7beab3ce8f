// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/fields/describe.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// Request of `setae params`.
struct ParametersRequest {
    study::SurfaceInput surface;
    study::SurfaceAnalysisOptions analysis;
    bool every_measurement = false;  ///< the first failure of one is thrown, in place of parameters without it
    /// Names or symbols of the wanted parameters; empty: all. No spectrum is computed for those of one pass over
    /// heights.
    std::vector<std::string> only = {};
};

/// Parameters that belong together: of one measurement's heights, or of the surface's spectrum.
struct ParameterGroup {
    std::string file, name;
    std::string purpose;  ///< purpose of these numbers
    std::vector<Quantity> quantities;
    std::optional<std::size_t> channel = {};  ///< that was taken where the file has several
};

/// Parameters of a surface: those of each measurement's heights, then those of its spectrum by the requested
/// conversion, then by the other one. Without groups where the surface failed.
struct Parameters {
    study::SurfaceResult surface;
    std::vector<ParameterGroup> groups;
    /// The numbers to quote: rms height, slope, curvature and true area of the waves inside the reliable band.
    std::vector<Quantity> headline;
    std::string levelling;  ///< trend removed from the heights before, by measurement; empty for a given spectrum
};

/// The headline in words: the numbers with their standard errors, their waves, the removed trend and the measurements.
[[nodiscard]] std::string headline_text(const Parameters& parameters);

/// @throws InvalidArgument for a name that no parameter has; what reading throws where every measurement is requested.
[[nodiscard]] Parameters parameters(const ParametersRequest& request, parallel::Threads threads = {});

/// A parameter with its origin.
struct ParameterEntry {
    Quantity quantity;
    std::string file, measurement;
    std::optional<std::size_t> channel;
    std::string purpose;
    bool headline = false;  ///< whether it is one to quote
    std::string levelling;  ///< of one to quote
};

/// Parameters of all groups.
[[nodiscard]] std::vector<ParameterEntry> parameter_entries(const Parameters& parameters);

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::answers::ParameterEntry> {
    using T = answers::ParameterEntry;
    static constexpr std::array rows{
        quantity_fields<T>([](const T& of) -> const Quantity& { return of.quantity; }),
        field<&T::file>("file", "name of the file as it was given; `combined` for several measurements"),
        field<&T::measurement>("measurement", "name of the measurement"),
        field<&T::channel>("channel", "number of the channel within the file, counted from 0"),
        field<&T::purpose>("purpose", "purpose of the number: to be reported, or to be compared with another number"),
        field<&T::headline>("headline", "whether it is one of the numbers to report"),
        field<&T::levelling>("levelling", "trend that was removed from the heights before, for a number to report")
            .with(Missing::left_out),
        inner<&T::quantity>(),
    };
    static constexpr Description description{"", "parameters of measurements and of their spectrum", rows};
};
static_assert(setae::fields::complete<setae::answers::ParameterEntry>);
