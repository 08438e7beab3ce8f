// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/core/table.hpp"
#include "setae/fields/option.hpp"
#include "setae/spectra/self_affine_fit.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// Two wavevectors [1/m], "1e5:1e8". @throws InvalidArgument.
[[nodiscard]] Band wavevector_range(const std::string& text);

/// Whether and how a self-affine surface is fitted.
struct SelfAffineRequest {
    bool wanted = false;
    std::string range;
    bool no_rolloff = false, short_cutoff = false;
};

/// A self-affine surface fitted to the spectra of all measurements, each in the range without effects of window and
/// sampling. @throws InvalidArgument for a malformed range; what the fit throws.
[[nodiscard]] spectra::SelfAffineFit fitted(const study::SurfaceResult& surface, const SelfAffineRequest& request);

/// Its parameters that were fitted.
[[nodiscard]] std::vector<Quantity> parameters_of(const spectra::SelfAffineFit& fit);

/// Columns C1D_model, C1D_model_standard_error and extrapolated (1 outside the range of the fit) at the wavevectors of
/// a table, and the parameters in its header.
void add_model(Table& table, const spectra::SelfAffineFit& fit);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::SelfAffineRequest> {
    using R = answers::SelfAffineRequest;
    static constexpr std::array options{
        option<&R::wanted>("fit", "fit of a self-affine surface: H, C_0 and roll-off"),
        option<&R::range>("fit_range", "wavevectors of the self-affine fit in 1/m")
            .read_by([](const std::string& text) { (void)answers::wavevector_range(text); })
            .such_as("1e5:1e8")
            .or_else("all")
            .advanced(),
        option<&R::no_rolloff>("no_rolloff", "self-affine fit of a power law without roll-off").advanced(),
        option<&R::short_cutoff>("short_cutoff", "the self-affine fit also finds where the spectrum ends").advanced(),
    };
};
