// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/report/report.hpp"

namespace setae::report {

/// Reliable band of each measurement with its limits; failures with their reasons.
[[nodiscard]] std::string cut_html(const study::StudyResult& result);

/// Every warning, grouped by code.
[[nodiscard]] std::string alerts_html(const study::StudyResult& result);

/// Processing of each measurement, and the methods in words.
[[nodiscard]] std::string steps_html(const study::StudyResult& result);
[[nodiscard]] std::string methods_html(const study::StudyResult& result);

/// Version, command, time, inputs with their digests, options.
[[nodiscard]] std::string provenance_html(const study::StudyResult& result, const RunRecord& run);

/// References to cite.
[[nodiscard]] std::string references_html();

}  // namespace setae::report
