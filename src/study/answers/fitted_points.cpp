// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/fitted_points.hpp"

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::answers {
namespace {

/// The series that were measured.
Table measured(const Array1D& time, const Array1D& force, const Array1D& displacement, const Array1D& radius) {
    Table table;
    for (const auto& column : {Column{"time", "s", time}, Column{"force", "N", force},
                               Column{"displacement", "m", displacement}, Column{"contact_radius", "m", radius}})
        if (column.values.size() > 0) table.columns.push_back(column);
    return table;
}

}  // namespace

Table corrected_record(const AnalysedLoop& loop) {
    const auto& record = loop.analysis.corrected;
    return measured(record.time, record.force, record.displacement, record.contact_radius);
}

Table fitted_samples(const AnalysedLoop& loop, loops::LoopBranch branch) {
    try {
        const auto samples = loops::branch_samples(loop.analysis, branch, loop.options);
        return measured(samples.time, samples.data.force, samples.data.displacement, samples.data.contact_radius);
    } catch (const UndefinedDataError&) {
        return {};
    }
}

Table fitted_segment(const loops::ForceCurveFit& fit) {
    Array1D best = Array1D::Constant(fit.segment.force.size(), undefined);
    best(fit.samples) = fit.segment.force(fit.samples) - fit.residuals;
    return {.columns = {{"displacement", "m", fit.segment.displacement},
                        {"force", "N", fit.segment.force},
                        {"best_fit", "N", best}},
            .metadata = {}};
}

}  // namespace setae::answers
