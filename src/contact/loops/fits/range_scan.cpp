// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/range_scan.hpp"

#include <algorithm>
#include <cmath>

#include "attempt.hpp"
#include "contact_analysis.hpp"
#include "finite_height.hpp"
#include "setae/core/constants.hpp"

namespace setae::loops {
namespace {

/// Common data of all fits of the scan.
struct Scan {
    const LoopAnalysis& analysis;
    const LensAndCounterBody& bodies;
    const AnalysisOptions& options;

    [[nodiscard]] Selection loading(Index dropped) const {
        const Segments& segments = analysis.segments;
        return without_ignored(loading_selection(analysis.corrected, segments, segments.contacts.front(), dropped),
                               segments);
    }
    [[nodiscard]] RangeFit fit(Index dropped, double force_share) const {
        Selection selection = loading(dropped);
        const double last = force_share * analysis.corrected.force[analysis.segments.contacts.front().loading.last];
        const auto beyond = std::find_if(selection.samples.begin(), selection.samples.end(),
                                         [&](Index i) { return analysis.corrected.force[i] > last; });
        selection.samples.erase(beyond, selection.samples.end());
        return {
            .dropped = dropped,
            .force_share = force_share,
            .fit = attempt([&] {
                return primary_fit(
                    as_half_space(branch_data({analysis.corrected, analysis.segments.before, analysis.force_zero.modes},
                                              selection, options),
                                  bodies, options),
                    bodies, options);
            })};
    }
};

/// Slope of W against E*, both with errors of their own: the major axis of the points, each coordinate in its mean.
double slope_of(const std::vector<RangeFit>& fits) {
    std::vector<double> moduli, works;
    for (const auto& f : fits) {
        if (!f.fit || !f.fit->converged) continue;
        moduli.push_back(f.fit->contact_modulus.value);
        works.push_back(f.fit->work_of_adhesion.value);
    }
    const auto n = static_cast<Index>(moduli.size());
    if (n < 3) return undefined;
    const Array1D modulus = Eigen::Map<const Array1D>(moduli.data(), n),
                  work = Eigen::Map<const Array1D>(works.data(), n);
    const Array1D x = modulus / modulus.mean() - 1.0, y = work / work.mean() - 1.0;
    const double xx = x.square().sum(), yy = y.square().sum(), xy = (x * y).sum();
    const double tangent = (yy - xx + std::hypot(yy - xx, 2.0 * xy)) / (2.0 * xy);
    return tangent * work.mean() / modulus.mean();
}

}  // namespace

RangeScan scan_ranges(const LoopAnalysis& analysis, const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    const Scan scan{analysis, bodies, options};
    RangeScan result;
    const auto samples = static_cast<Index>(scan.loading(0).samples.size());
    for (const Index dropped : {0, 1, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, 100})
        if (2 * dropped <= samples) result.by_start.push_back(scan.fit(dropped, 1.0));
    for (int tenths = 3; tenths <= 10; ++tenths)
        result.by_end.push_back(scan.fit(options.samples_dropped, 0.1 * tenths));
    if (!result.by_end.back().fit) throw UndefinedDataError(result.by_end.back().fit.reason);
    auto all = result.by_start;
    all.insert(all.end(), result.by_end.begin(), result.by_end.end());
    result.slope = slope_of(all);
    const JkrFit& whole = *result.by_end.back().fit;
    result.ellipse_slope =
        whole.correlation * whole.work_of_adhesion.standard_error / whole.contact_modulus.standard_error;
    return result;
}

}  // namespace setae::loops
