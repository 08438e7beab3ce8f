// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "autocorrelation_result.hpp"
#include "line_pairs.hpp"
#include "padded_rows.hpp"
#include "radial_bins.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/scales/autocorrelation.hpp"

namespace setae::scales {
namespace {

using fourier::Buffer;
using fourier::Complex;

/// Sums over pairs by lag (k, l), k = −x … x, l = 0 … y.
struct LagSums {
    Index x, y;
    Array2D squares, pairs;
    LagSums(Index lags_x, Index lags_y)
        : x(lags_x), y(lags_y), squares(Array2D::Zero(2 * x + 1, y + 1)), pairs(squares) {}
};

/// Heights of a band: lines that begin pairs and lines that end them.
struct ScanLines {
    Array2D heights;  ///< (nx, lines and overlap), centred; NaN = undefined
    Index lines = 0;  ///< that begin pairs
};

/// Weights, heights and squares of the first `lines` lines of a band as row spectra.
struct Spectra {
    RowSpectra weights, heights, squares;

    Spectra(const Array2D& values, Index lines, const fourier::RealTransform& along_y, parallel::Threads threads) {
        const auto rows_of = [&](auto function, RowSpectra& spectra) {
            transform_rows(
                values.rows(), lines, along_y,
                [&](Index i, double* line) {
                    for (Index j = 0; j < lines; ++j)
                        line[j] = values(i, j) == values(i, j) ? function(values(i, j)) : 0.0;
                },
                spectra, threads);
        };
        rows_of([](double) { return 1.0; }, weights);
        rows_of([](double h) { return h; }, heights);
        rows_of([](double h) { return h * h; }, squares);
    }
};

/// Adds the pairs that begin in the band: cross-correlations of its lines with its lines and overlap.
void add_band(const ScanLines& band, bool periodic, LagSums& sums, parallel::Threads threads) {
    const Index nx = band.heights.rows(), padded_x = periodic ? nx : fourier::fast_length(nx + sums.x),
                padded_y = fourier::fast_length(band.lines + sums.y);
    const fourier::RealTransform along_y(padded_y);
    const fourier::InverseRealTransform back_along_y(padded_y);
    const fourier::ComplexTransform along_x(padded_x), back_along_x(padded_x, fourier::ComplexTransform::Sign::plus);
    const Index modes = along_y.modes(), lags = 2 * sums.x + 1;
    const Spectra first(band.heights, band.lines, along_y, threads),
        second(band.heights, band.heights.cols(), along_y, threads);
    RowSpectra differences(extent(lags * modes)), pairs(extent(lags * modes));
    parallel::for_each_index(extent(fourier::block_count(modes)), threads, [&](std::size_t block) {
        Columns u[3]{Columns(padded_x), Columns(padded_x), Columns(padded_x)},
            v[3]{Columns(padded_x), Columns(padded_x), Columns(padded_x)};
        const Index begin = static_cast<Index>(block) * fourier::lines_per_block,
                    count = std::min(fourier::lines_per_block, modes - begin);
        const RowSpectra* of_first[3] = {&first.weights, &first.heights, &first.squares};
        const RowSpectra* of_second[3] = {&second.weights, &second.heights, &second.squares};
        for (int part = 0; part < 3; ++part) {
            u[part].take(*of_first[part], nx, modes, begin, count);
            v[part].take(*of_second[part], nx, modes, begin, count);
            for (Index m = 0; m < count; ++m) {
                along_x.apply(u[part].column(m));
                along_x.apply(v[part].column(m));
            }
        }
        for (Index m = 0; m < count; ++m) {
            Complex *difference = u[1].column(m), *pair = u[0].column(m);
            for (Index p = 0; p < padded_x; ++p) {
                const Complex w = std::conj(u[0].column(m)[p]), g = std::conj(u[1].column(m)[p]),
                              s = std::conj(u[2].column(m)[p]);
                difference[p] = 0.5 * (s * v[0].column(m)[p] + w * v[2].column(m)[p]) - g * v[1].column(m)[p];
                pair[p] = w * v[0].column(m)[p];
            }
            back_along_x.apply(difference);
            back_along_x.apply(pair);
            for (Index k = -sums.x; k <= sums.x; ++k) {
                const Index from = k < 0 ? padded_x + k : k, to = (k + sums.x) * modes + begin + m;
                differences[extent(to)] = difference[from];
                pairs[extent(to)] = pair[from];
            }
        }
    });
    const double scale = 1.0 / (static_cast<double>(padded_x) * static_cast<double>(padded_y));
    parallel::for_each_index(extent(lags), threads, [&](std::size_t row) {
        Buffer<double> line(extent(padded_y));
        const Index k = static_cast<Index>(row);
        back_along_y.apply(differences.data() + k * modes, line.data());
        for (Index l = 0; l <= sums.y; ++l) sums.squares(k, l) += line[extent(l)] * scale;
        back_along_y.apply(pairs.data() + k * modes, line.data());
        for (Index l = 0; l <= sums.y; ++l) sums.pairs(k, l) += std::round(line[extent(l)] * scale);
    });
}

/// Lines first … first + count − 1 of a map, beginning again at 0 in periodic maps.
Array2D lines_of(const topography::TiledMap& map, Index first, Index count) {
    const Index direct = std::min(count, map.ny - first);
    Array2D values(map.nx, count);
    values.leftCols(direct) = map.lines(first, direct);
    if (direct < count) values.rightCols(count - direct) = map.lines(0, count - direct);
    return values;
}

double mean_of_defined(const Array2D& values) {
    double origin = undefined, sum = 0.0, count = 0.0;
    for (Index i = 0; i < values.size(); ++i) {
        const double h = values.data()[i];
        if (std::isnan(h)) continue;
        if (std::isnan(origin)) origin = h;
        sum += h - origin;
        count += 1.0;
    }
    return origin + sum / count;
}

}  // namespace

FunctionOfScale autocorrelation_of_area(const topography::TiledMap& map, double longest, const spectra::LogGrid& grid,
                                        std::size_t band_bytes, const AutocorrelationOptions& options) {
    const auto pixel_size = map.pixel_size();
    const Index max_x = map.periodic ? map.nx / 2 : map.nx - 1, max_y = map.periodic ? map.ny / 2 : map.ny - 1;
    const double most =
        std::min(static_cast<double>(max_x) * pixel_size[0], static_cast<double>(max_y) * pixel_size[1]);
    if (!(longest >= std::max(pixel_size[0], pixel_size[1]) && longest <= most))
        throw InvalidArgument(fmt::format("{}: longest distance {} m; expected between one pixel, {} m, and {} m",
                                          topography::label(map.metadata), longest,
                                          std::max(pixel_size[0], pixel_size[1]), most));
    const auto lags_along = [&](double step) { return static_cast<Index>(std::floor(longest / step * (1.0 + 1e-12))); };
    LagSums sums(lags_along(pixel_size[0]), lags_along(pixel_size[1]));
    constexpr std::size_t arrays = 8;  // of a band with its overlap: heights as read and centred, six spectra
    const Index lines =
        std::min(map.ny, std::max({topography::lines_in(map, band_bytes / arrays) - sums.y, sums.y, Index{1}}));
    bool any_defined = false;
    for (Index first = 0; first < map.ny; first += lines) {
        ScanLines band;
        band.lines = std::min(lines, map.ny - first);
        band.heights =
            lines_of(map, first, map.periodic ? band.lines + sums.y : std::min(band.lines + sums.y, map.ny - first));
        const double origin = mean_of_defined(band.heights);
        if (std::isnan(origin)) continue;
        any_defined = true;
        band.heights -= origin;  // each band about its own origin, which cancels in differences of heights
        add_band(band, map.periodic, sums, options.threads);
    }
    if (!any_defined)
        throw UndefinedDataError(fmt::format("{}: no height is defined, so that there is no autocorrelation",
                                             topography::label(map.metadata)));

    // half a plane with k >= 0 from half a plane with l >= 0: A(−d) = A(d)
    const RadialBins bins(grid, pixel_size, longest);
    RadialBins::Row row(extent(bins.size()));
    Buffer<double> values(extent(2 * sums.y + 1));
    for (Index k = 0; k <= sums.x; ++k) {
        for (Index l = -sums.y; l <= sums.y; ++l) {
            const Index at_x = sums.x + (l >= 0 ? k : -k), at_y = std::abs(l);
            const double pairs = sums.pairs(at_x, at_y);
            values[extent(sums.y + l)] = pairs > 0.5 ? std::max(0.0, sums.squares(at_x, at_y) / pairs) : undefined;
        }
        bins.add(k, values.data(), sums.y, k == 0 ? 1.0 : 2.0, row);
    }
    auto result = radial_average(row, map.metadata);
    result.reliable_from =
        std::max({0.5 * shortest_reliable_wavelength(map, lines, options.reliability, options.threads), pixel_size[0],
                  pixel_size[1]});
    return result;
}

}  // namespace setae::scales
