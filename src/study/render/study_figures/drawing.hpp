// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "arrangement.hpp"
#include "builders.hpp"
#include "setae/core/estimate.hpp"
#include "setae/figures/instrument_look.hpp"

namespace setae::study_figures {

/// Colours of the palette of figures.
namespace colour {
inline constexpr int blue = 0, vermilion = 1, green = 2, pink = 3, black = 4, orange = 5, sky = 6;
}

inline constexpr double MPa = 1e-6, mJ = 1e3;  ///< per SI unit
/// Pairs that a comparison of balances or of W_ret needs: with two, one degree of freedom compares nothing.
inline constexpr std::size_t min_compared_pairs = 3;

[[nodiscard]] inline bool wide(const FigureRequest& request) {
    return request.options.width == FigureWidth::double_column;
}

[[nodiscard]] Array1D array_of(const std::vector<double>& values);

/// A curve of a spectrum, at most `most` points: means over even steps of ln q where it has more.
struct DrawnCurve {
    Array1D x, y;
};
[[nodiscard]] DrawnCurve log_means(const DrawnCurve& curve, Index most = 150);

/// Samples that show a record in at most about `most` points: every so many, and both ends of each jump.
[[nodiscard]] std::vector<Index> thinned(const Array1D& x, const Array1D& y, Index first, Index last, Index most = 400);
[[nodiscard]] Array1D taken(const Array1D& values, const std::vector<Index>& samples);

/// Surfaces that one figure shows: the first of many.
[[nodiscard]] std::span<const study::SurfaceResult> drawn_surfaces(const study::StudyResult& result);
/// A sentence for the caption where a figure leaves surfaces out; empty where it shows all.
[[nodiscard]] std::string left_out_surfaces(const study::StudyResult& result);

/// Colour and symbol of a surface or an elastomer by its position in the study; black is reserved for lines that are no
/// data.
[[nodiscard]] int colour_of_place(std::size_t place);
[[nodiscard]] std::size_t place_of_surface(const study::StudyResult& result, const std::string& name);
[[nodiscard]] std::size_t place_of_elastomer(const study::StudyResult& result, const std::string& name);

/// A surface's name in a legend, with "(reconstruction)" where its spectrum is reconstructed from published moments.
[[nodiscard]] std::string label_of(const study::SurfaceResult& surface);

/// Name of a type of instruments for readers: "AFM" for "afm".
[[nodiscard]] std::string instrument_in_words(const std::string& type);
/// Name of a measurement's instrument for readers; its own name where the type is unknown.
[[nodiscard]] std::string instrument_of(const study::MeasurementResult& measurement);
/// Instruments of all measurements that were analysed, coarsest first.
struct InstrumentBand {
    std::string instrument;
    Band band;  ///< from the lowest to the highest wavevector any of them shows reliably
};
[[nodiscard]] std::vector<InstrumentBand> instrument_bands(const std::vector<const study::SurfaceResult*>& surfaces);

/// "37.1 ± 3.5 mJ/m2": value and standard error times `factor`.
[[nodiscard]] std::string with_error(const Estimate& estimate, double factor, const std::string& unit);

/// Note for figures of a spectrum reconstructed from published moments; empty where none is.
[[nodiscard]] std::string reconstruction_note(const study::StudyResult& result);
/// Pairs of such spectra for which the full-contact balance (Eq. 7) is floored although adhesion was measured, and the
/// largest stored energy without a floor; empty where there is none.
[[nodiscard]] std::string floored_note(const study::StudyResult& result);

/// "one pair", "3 pairs".
[[nodiscard]] std::string counted(std::size_t n, const std::string& thing);

}  // namespace setae::study_figures
