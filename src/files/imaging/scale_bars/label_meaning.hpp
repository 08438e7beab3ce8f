// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace setae::imaging {

/// Meaning of the label of a scale bar.
struct LabelMeaning {
    std::string text;              ///< number, blank, unit: "5 nm"; otherwise as read
    std::string unit;              ///< "pm", "A", "nm", "um", "mm"; empty without one
    std::optional<double> length;  ///< [m]
    std::string fault;             ///< why there is no length
};

/// Number and unit of a length in a label read without blanks; a comma counts as a point.
///
/// Lengths of bars are 1, 2, 2.5 or 5 times a power of ten: another number is a reading error, or must be confirmed by
/// the user. A reciprocal length ("5 1/nm") belongs to a diffraction pattern and is no length.
[[nodiscard]] LabelMeaning meaning_of_label(std::string_view reading);

}  // namespace setae::imaging
