// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/report/report.hpp"

namespace setae::report {

/// Per measurement the band that is trusted and what limited it; what failed, with its reason.
[[nodiscard]] std::string cut_html(const study::StudyResult& result);

/// Every alert, grouped by code.
[[nodiscard]] std::string alerts_html(const study::StudyResult& result);

/// What was done to each measurement, and the methods in words.
[[nodiscard]] std::string steps_html(const study::StudyResult& result);
[[nodiscard]] std::string methods_html(const study::StudyResult& result);

/// Version, command, time, inputs with their digests, options.
[[nodiscard]] std::string provenance_html(const study::StudyResult& result, const RunRecord& run);

/// What to cite.
[[nodiscard]] std::string references_html();

}  // namespace setae::report
