// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/detrend.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "polynomial_fit.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/legendre.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::topography {
namespace {

constexpr std::array<std::pair<Trend, const char*>, 4> trend_names{
    {{Trend::none, "none"}, {Trend::mean, "mean"}, {Trend::tilt, "tilt"}, {Trend::parabola, "parabola"}}};

PolynomialDegrees degrees_of(Trend trend) {
    return {.total = trend == Trend::parabola ? 2 : trend == Trend::tilt ? 1 : 0};
}

/// Coefficients of the best trend of heights minus their origin, or of one of the possible trends if the points do not
/// determine it.
Array2D best(const Terms& terms, const NormalEquations& equations) {
    if (equations.points < terms.count())
        throw UndefinedDataError(
            fmt::format("{} defined heights are too few for a trend with {} coefficients; expected at least as many",
                        equations.points, terms.count()));
    const auto determined = numerics::solved_normal_equations(equations.gram, equations.moments);
    const Eigen::MatrixXd gram = equations.gram.matrix();
    return arranged(terms, determined ? *determined : Array1D(gram.ldlt().solve(equations.moments.matrix()).array()),
                    0.0);
}

/// Subtracts the trend from rows of equal steps; a line is the columns of a single row.
void remove(const Terms& terms, Eigen::Ref<Array2D> heights, parallel::Threads threads) {
    PolynomialFit fit(terms, heights.cols());
    fit.add(heights, 0, nullptr, threads);
    const auto equations = fit.equations();
    subtract(equations.origin, best(terms, equations), heights, 0, heights.cols(), threads);
}

}  // namespace

HeightMap detrended(HeightMap&& map, Trend trend, parallel::Threads threads) {
    if (trend != Trend::none) remove(terms_of(degrees_of(trend), false), map.heights, threads);
    return std::move(map);
}

MapTrend::MapTrend(const ArrayView2D& heights, Trend trend, parallel::Threads threads) {
    if (trend == Trend::none) throw InvalidArgument("a map has the trend 'none'; expected mean, tilt or parabola");
    const auto terms = terms_of(degrees_of(trend), false);
    PolynomialFit fit(terms, heights.cols());
    fit.add(heights, 0, nullptr, threads);
    const auto equations = fit.equations();
    rows_ = std::make_shared<const PolynomialRows>(equations.origin, best(terms, equations), heights.rows(),
                                                   heights.cols());
}

void MapTrend::take_from(Index i, const double* heights, double* rest) const {
    rows_->take_from(i, 0, heights, rest, rows_->lines());
}

HeightMap detrended(const HeightMap& map, Trend trend, parallel::Threads threads) {
    if (trend == Trend::none) return map;
    const MapTrend removed(map.heights, trend, threads);
    HeightMap result{Array2D(map.heights.rows(), map.heights.cols()), map.size, map.periodic, map.metadata};
    numerics::for_each_row(map.heights.rows(), map.heights.cols(), threads, [&](Index i) {
        removed.take_from(i, map.heights.row(i).data(), result.heights.row(i).data());
    });
    return result;
}

TiledMap detrended(TiledMap map, Trend trend, Index lines_together, parallel::Threads threads) {
    if (trend == Trend::none) return map;
    const auto terms = terms_of(degrees_of(trend), false);
    PolynomialFit fit(terms, map.ny);
    for (Index first = 0; first < map.ny; first += lines_together)
        fit.add(map.lines(first, std::min(lines_together, map.ny - first)), first, nullptr, threads);
    const auto equations = fit.equations();
    map.lines = [lines = std::move(map.lines), origin = equations.origin, removed = best(terms, equations), ny = map.ny,
                 threads](Index first, Index count) {
        auto band = lines(first, count);
        subtract(origin, removed, band, first, ny, threads);
        return band;
    };
    return map;
}

LineScan detrended(LineScan scan, Trend trend) {
    if (trend != Trend::none)
        remove(turned(terms_of(degrees_of(trend), true)),
               Eigen::Map<Array2D>(scan.heights.data(), 1, scan.heights.size()), {});
    return scan;
}

Profile detrended(Profile profile, Trend trend) {
    if (trend == Trend::none) return profile;
    const auto terms = terms_of(degrees_of(trend), true);
    const PolylinePlaces places(profile);
    const auto equations = polyline_equations(profile, places, terms, {});
    profile.heights -= equations.origin;
    subtract({best(terms, equations), {places.middle, 0.0}, {places.half, 1.0}}, profile);
    return profile;
}

Measurement detrended(Measurement measurement, Trend trend, parallel::Threads threads) {
    if (auto* map = std::get_if<HeightMap>(&measurement)) return detrended(std::move(*map), trend, threads);
    if (auto* scan = std::get_if<LineScan>(&measurement)) return detrended(std::move(*scan), trend);
    return detrended(std::get<Profile>(std::move(measurement)), trend);
}

Trend trend_from_name(const std::string& name) {
    for (const auto& [trend, known] : trend_names)
        if (name == known) return trend;
    // the equivalent steps of processing
    if (name == "level_mean") return Trend::mean;
    if (name == "level_plane") return Trend::tilt;
    if (name == "level_polynomial") return Trend::parabola;
    throw InvalidArgument(fmt::format("'{}' is not a trend; expected none, mean, tilt or parabola", name));
}

std::string name(Trend trend) {
    for (const auto& [known, text] : trend_names)
        if (known == trend) return text;
    throw InternalError("trend without a name");
}

}  // namespace setae::topography
