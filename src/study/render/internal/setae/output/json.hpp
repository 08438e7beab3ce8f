// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"

namespace setae::processing {
struct StepRecord;
}
namespace setae::roughness {
enum class Conversion;
}
namespace setae::study {
struct MeasurementResult;
struct SpectrumResult;
struct StudyResult;
struct SurfaceAnalysisOptions;
struct SurfaceResult;
}  // namespace setae::study

namespace setae::output {

/// Keys keep the order in which they are written. Code that does more than pass it on includes <nlohmann/json.hpp>.
using Json = nlohmann::ordered_json;

/// {"quantity", "symbol", "value", "unit"} and, where they exist, "standard_error", "interval" (lower, upper, level),
/// "method", "degrees_of_freedom", "seed", "band", "n", "source", "alerts". SI; NaN is null; infinity is the text
/// "infinity" or "-infinity".
[[nodiscard]] Json to_json(const Quantity& quantity);
[[nodiscard]] Json to_json(const std::vector<Alert>& alerts);

/// {"step", "numbers", "alerts"} for each applied step of a pipeline.
[[nodiscard]] Json to_json(const std::vector<processing::StepRecord>& records);

/// As a file holds it: objects indented by two, a list of numbers or texts on one line, a line feed at the end; bytes
/// that are no UTF-8 are U+FFFD.
[[nodiscard]] std::string as_text(const Json& json);

/// NaN to null, infinity to text.
[[nodiscard]] Json number(double value);
[[nodiscard]] Json numbers(const ArrayView1D& values);

/// A quantity in one line.
[[nodiscard]] Quantity quantity(std::string name, std::string symbol, double value, std::string unit);
/// Without a standard error > 0 or an interval it is printed as a plain value.
[[nodiscard]] Quantity quantity(std::string name, std::string symbol, const Estimate& estimate, std::string unit);

/// A surface as in the study's JSON: parameters by the spectrum used, "spectra", "likelihood", "measurements",
/// "alerts"; or "error".
[[nodiscard]] Json to_json(const study::SurfaceResult& surface, const study::SurfaceAnalysisOptions& options);

/// All results of a study: "fits", "surfaces", "elastomers", "pairs", "experiments", "references", "cutoff_scan",
/// "reported", "alerts", "provenance"; "by_average" where likelihoods are used. No clock time, so that equal input
/// gives equal bytes.
[[nodiscard]] Json to_json(const study::StudyResult& result);
/// The same as text, in pieces, so that thousands of measurements, surfaces and experiments need not be in memory
/// twice.
void write_json(const study::StudyResult& result, const std::function<void(std::string_view)>& write);
/// The JSON with null for columns of more than 16 numbers, and only the first entries of longer lists: surfaces, a
/// surface's measurements, pairs, warnings, inputs; fewer for experiments.
[[nodiscard]] Json json_without_curves(const study::StudyResult& result, std::size_t max_entries,
                                       std::size_t max_experiments);

/// Parameters of the heights of one measurement as quantities: Rq or Sq, slopes, curvature, triangulated area, tests.
[[nodiscard]] std::vector<Quantity> measurement_quantities(const study::MeasurementResult& measurement);

/// Parameters of one spectrum of a surface as quantities, with their uncertainties and band.
[[nodiscard]] std::vector<Quantity> surface_quantities(const study::SurfaceResult& surface,
                                                       const study::SpectrumResult& spectrum,
                                                       roughness::Conversion conversion);

/// Mean of C1D over each decade that one spectrum of a measured surface spans, with its uncertainty; none for others.
[[nodiscard]] std::vector<Quantity> decade_quantities(const study::SurfaceResult& surface,
                                                      const study::SpectrumResult& spectrum);

}  // namespace setae::output
