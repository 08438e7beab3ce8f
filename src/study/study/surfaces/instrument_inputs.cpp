// SPDX-License-Identifier: GPL-3.0-or-later
#include "instrument_inputs.hpp"

#include <fmt/format.h>

#include "setae/core/units.hpp"

namespace setae::study {
namespace {

std::string name_of(const std::string& given, const char* quantity, const std::string& instrument,
                    const std::string& value, const std::string& surface) {
    if (!given.empty()) return given;
    return fmt::format("{}{}{}, {}", quantity, instrument.empty() ? "" : " of " + instrument,
                       value.empty() ? "" : " (" + value + ")", surface);
}

std::string name_of_calibration(const Estimate& calibration, const char* quantity, const std::string& instrument,
                                const std::string& surface) {
    if (!calibration.uncertain()) return {};
    const auto value = calibration.value == 1.0 ? std::string() : fmt::format("{:.6g}", calibration.value);
    return name_of(calibration.input, quantity, instrument, value, surface);
}

InputNames names_of(const InstrumentInputs& inputs, const topography::Instrument& instrument,
                    const std::string& surface) {
    InputNames names;
    if (instrument.tip_radius && instrument.tip_radius_standard_error)
        names.tip_radius = name_of(inputs.tip_radius, "tip radius", instrument.type,
                                   format_value(*instrument.tip_radius, "m", 3), surface);
    names.height_calibration =
        name_of_calibration(inputs.height_calibration, "height calibration", instrument.type, surface);
    names.lateral_calibration =
        name_of_calibration(inputs.lateral_calibration, "lateral calibration", instrument.type, surface);
    return names;
}

}  // namespace

InputNames input_names(const MeasurementResult& measurement, const std::string& surface) {
    auto names = names_of(measurement.inputs, measurement.spectrum.metadata.instrument, surface);
    if (!measurement.bands_of_uncertain_tip) names.tip_radius.clear();
    return names;
}

InputNames input_names(const PreparedMeasurement& prepared, const std::string& surface) {
    const auto& instrument = topography::metadata(prepared.measurement).instrument;
    auto names = names_of(prepared.inputs, instrument, surface);
    names.probe_size = names.tip_radius;
    if (!prepared.probe || !prepared.probe->is_foil()) return names;
    names.probe_size = prepared.probe->size_error > 0.0
                           ? name_of(prepared.inputs.foil_thickness, "foil thickness", instrument.type,
                                     format_value(prepared.probe->size, "m", 3), surface)
                           : std::string();
    return names;
}

double relative_error(const Estimate& estimate) {
    return estimate.uncertain() ? estimate.standard_error / estimate.value : 0.0;
}

}  // namespace setae::study
