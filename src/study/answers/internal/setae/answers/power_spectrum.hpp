// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "setae/answers/self_affine.hpp"
#include "setae/core/table.hpp"
#include "setae/fields/option.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// Request of `setae psd`.
struct PowerSpectrumRequest {
    study::SurfaceInput surface;
    study::SurfaceAnalysisOptions analysis;
    bool isotropic = false, abel = false, binned = false;
    SelfAffineRequest fit;
    bool every_measurement = false;  ///< the first failure of one is thrown, in place of a spectrum without it
};

/// The spectrum of a surface: C1D of a single measurement, mode by mode, or of all in the bins of the combined grid.
///
/// Columns: wavevector [1/m], C1D [m³], standard_error [m³], count; and further columns on request. Without columns
/// where the surface failed.
struct PowerSpectrum {
    study::SurfaceResult surface;
    Table table;
    std::optional<spectra::SelfAffineFit> fit;
};

/// @throws InvalidArgument for requests that a table of a spectrum cannot fulfil; what the fit throws; what reading
/// throws where every measurement is requested.
[[nodiscard]] PowerSpectrum power_spectrum(const PowerSpectrumRequest& request, parallel::Threads threads = {});

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::PowerSpectrumRequest> {
    using R = answers::PowerSpectrumRequest;
    static constexpr std::array options{
        option<&R::isotropic>("iso", "also C_iso, on the combined grid").in_python("isotropic"),
        option<&R::abel>("abel", "also C_iso by the inverse Abel transform, on the combined grid"),
        option<&R::binned>("binned", "one measurement is shown on the combined grid, too"),
    };
};
