// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/diagnosis.hpp"

#include <iterator>
#include <utility>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::answers {
namespace {

void append(std::vector<diagnostics::Finding>& findings, std::vector<diagnostics::Finding> found) {
    findings.insert(findings.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
}

/// A radius in place of that of the file, and of its standard error.
void set_tip(topography::Instrument& instrument, const Estimate& radius) {
    instrument.tip_radius = radius.value;
    instrument.tip_radius_standard_error.reset();
    if (radius.uncertain()) instrument.tip_radius_standard_error = radius.standard_error;
}

/// Findings from reading the heights.
std::vector<diagnostics::Finding> of_reading(const topography::Measurement& measurement) {
    std::vector<diagnostics::Finding> findings;
    for (const auto& alert : topography::metadata(measurement).alerts) findings.push_back({alert, {}});
    return findings;
}

}  // namespace

std::vector<topography::Measurement> measurements_of(const std::string& path, const FileRequest& options) {
    std::vector<topography::Measurement> found;
    for (const auto& channel : formats::open_chosen(path, options.channel, options.read_options()))
        found.push_back(channel.read());
    return found;
}

Diagnosis diagnosis(const std::vector<Suspect>& suspects, const DiagnosisRequest& request, parallel::Threads threads,
                    bool every_measurement) {
    if (suspects.empty()) throw InvalidArgument("no file; expected at least one measurement");
    const diagnostics::DiagnosisOptions options{.threads = threads};
    std::optional<Estimate> radius;
    if (!request.tip_radius.empty()) radius = parse_uncertain_quantity(request.tip_radius, positive(dimension::length));
    Diagnosis diagnosis;
    std::vector<topography::Measurement> all;
    for (const auto& suspect : suspects) {
        try {
            for (auto& measurement : suspect.measurements()) {
                if (radius) set_tip(topography::metadata(measurement).instrument, *radius);
                auto found = of_reading(measurement);
                append(found, diagnostics::diagnose(measurement, options));
                if (found.empty()) diagnosis.faultless.push_back(topography::label(topography::metadata(measurement)));
                append(diagnosis.findings, std::move(found));
                all.push_back(std::move(measurement));
            }
        } catch (const Error& error) {
            if (every_measurement) throw;
            diagnosis.failures.emplace_back(error.what());
        } catch (const std::exception& error) {
            if (every_measurement) throw;
            diagnosis.failures.push_back(reason_of(error, suspect.file));
        }
    }
    if (all.size() > 1) append(diagnosis.findings, diagnostics::diagnose_overlap(all, options));
    return diagnosis;
}

}  // namespace setae::answers
