// SPDX-License-Identifier: GPL-3.0-or-later
// Tips other than spheres, foils in projection, and microscopes that blur: their expectation in the fit.
#include "setae/spectral_fit/probe.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/spectral_fit/tip_response.hpp"
#include "setae/synthesis/height_transform.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/dilation.hpp"

namespace setae::spectral_fit::probe_test {
namespace {

constexpr double step = 10e-9;

/// Constant below 2π/1 µm, decreasing as q^-3.6 down to waves of 80 nm.
spectra::SpectralDensity rough(double slope) {
    const double bend = 2.0 * pi / 1e-6, end = 2.0 * pi / 80e-9;
    // h'² = (1/2π) ∫ q³ C dq, C = c (q/q_b)^-3.6 above q_b
    const double moment = std::pow(bend, 4) * (0.25 + (std::pow(end / bend, 0.4) - 1.0) / 0.4) / (2.0 * pi);
    const double level = slope * slope / moment;
    return [=](double q) { return q > end ? 0.0 : level * (q < bend ? 1.0 : std::pow(q / bend, -3.6)); };
}

TipSimulation simulation(const Probe& probe) {
    return {.probe = probe,
            .step = step,
            .points = 512,
            .length = 512,
            .repetitions = 4,
            .size_response = false,
            .correlation_length = 300e-9,
            .threads = {1}};
}

/// Power of modes first … last along every eighth line.
double band_power(const Array2D& heights, Index first, Index last) {
    const Index n = heights.rows();
    double sum = 0.0;
    for (Index j = 0; j < heights.cols(); j += 8)
        for (Index k = first; k <= last; ++k) {
            std::complex<double> mode = 0.0;
            for (Index i = 0; i < n; ++i)
                mode +=
                    heights(i, j) * std::polar(1.0, -2.0 * pi * static_cast<double>(i * k) / static_cast<double>(n));
            sum += std::norm(mode);
        }
    return sum;
}

/// At each point the highest over a thickness along y.
Array2D seen_through(const topography::HeightMap& surface, double thickness) {
    const Index n = surface.heights.rows(), lines = static_cast<Index>(std::lround(thickness / step)) + 1;
    return Array2D::NullaryExpr(n, n, [&](Index i, Index j) {
        double highest = surface.heights(i, j);
        for (Index l = 1; l < lines; ++l) highest = std::max(highest, surface.heights(i, (j + l) % n));
        return highest;
    });
}

/// T of a band by the simulation, and the ratio of powers of other surfaces read by `reading`.
struct Compared {
    double expected, read;
};
Compared compared(const Probe& probe, const std::function<Array2D(const topography::HeightMap&)>& reading) {
    constexpr Index n = 512, first = 10, last = 30;
    constexpr double slope = 0.5;
    const auto response = tip_response(rough(slope), simulation(probe));
    double plain = 0.0, read = 0.0, expected = 0.0, weight = 0.0;
    for (std::uint64_t r = 0; r < 4; ++r) {
        const auto surface =
            synthesis::random_surface(rough(slope), {n, n, n * step, n * step}, {.key = {77, r}, .threads = {1}});
        plain += band_power(surface.heights, first, last);
        read += band_power(reading(surface), first, last);
    }
    for (Index k = first; k <= last; ++k) {
        const double q = 2.0 * pi * static_cast<double>(k) / (n * step), C1D = std::pow(q, -2.6);
        Index at = 0;
        (response.wavevector - q).abs().minCoeff(&at);
        expected += C1D * std::exp(response.log_transfer[at]);
        weight += C1D;
    }
    return {expected / weight, read / plain};
}

/// A tip as a picture, apex up.
topography::HeightMap picture_of(const topography::Tip& tip, double pixel) {
    const auto image = topography::tip_image(tip, pixel, pixel, 400e-9);
    topography::HeightMap picture{-image.heights, {}, false, {}};
    picture.heights = picture.heights.isInf().select(undefined, picture.heights);
    picture.size = {static_cast<double>(image.heights.rows()) * pixel,
                    static_cast<double>(image.heights.cols()) * pixel};
    return picture;
}

// Four patches of sixteen lines a correlation length apart and twenty modes determine a ratio to 3 %, the simulation to
// as much.
TEST(Probe, OfEveryShapePredictsReadingsOfOtherSurfaces) {
    const auto dilated = [](const topography::Tip& tip) {
        return [tip](const topography::HeightMap& surface) {
            return topography::dilated(surface, tip, {.threads = {1}}).heights;
        };
    };
    const double angle = 65.0 * pi / 180.0;
    for (const auto& [probe, shape] :
         {std::pair{sphere({.value = 400e-9}), topography::Tip(topography::SphereTip{400e-9})},
          {paraboloid({.value = 400e-9}), topography::Tip(topography::ParabolicTip{400e-9})},
          {cone({.value = 20e-9}, angle), topography::Tip(topography::ConeTip{angle, 20e-9})}}) {
        const auto both = compared(probe, dilated(shape));
        EXPECT_NEAR(both.read, both.expected, 0.09) << probe.name;
        EXPECT_LT(both.read, 0.97) << probe.name;
    }
}

TEST(Probe, OfAFoilPredictsSilhouettesOfOtherSurfaces) {
    for (const double thickness : {50e-9, 200e-9, 800e-9}) {
        const auto both = compared(foil({.value = thickness}), [thickness](const topography::HeightMap& surface) {
            return seen_through(surface, thickness);
        });
        EXPECT_NEAR(both.read, both.expected, 0.09) << thickness;
        EXPECT_LT(both.read, 0.95) << thickness;
    }
}

TEST(Probe, FromAPictureHasTheShapeOfThePicture) {
    const auto picture = picture_of(topography::SphereTip{400e-9}, step);
    const auto tip = topography::tip_from_picture(picture);
    EXPECT_EQ(tip.centre_x, picture.heights.rows() / 2);
    const auto measured = measured_tip(tip, "tip.npy");
    EXPECT_NEAR(measured.size, 400e-9, 1e-9);
    const auto ball = tip_response(rough(0.5), simulation(sphere({.value = 400e-9})));
    const auto by_picture = tip_response(rough(0.5), simulation(measured));
    EXPECT_LT((ball.log_transfer - by_picture.log_transfer).abs().maxCoeff(), 1e-6);
}

TEST(Probe, IsNamedByShapeAndSize) {
    EXPECT_EQ(sphere({.value = 10e-9}).name, "sphere, 10 nm");
    EXPECT_EQ(cone({.value = 10e-9}, pi / 9.0).name, "cone of 20 degrees, 10 nm");
    const auto thicker = with_size(foil({.value = 10e-9}), 20e-9);
    EXPECT_EQ(std::get<Foil>(thicker.shape).thickness, 20e-9);
    EXPECT_THROW((void)sphere({.value = 0.0}), InvalidArgument);
    EXPECT_THROW((void)foil({.value = -1e-9}), InvalidArgument);
    EXPECT_THROW((void)cone({.value = 1e-9}, 2.0), InvalidArgument);
    topography::ArrayTip flat{Array2D::Zero(5, 5), {1e-9, 1e-9}, 2, 2};
    EXPECT_THROW((void)measured_tip(flat, "flat"), InvalidArgument);
}

TEST(OpticalTransfer, IsThatOfACircularAperture) {
    const OpticalTransfer optics{.numerical_aperture = 0.4, .light_wavelength = 500e-9};
    EXPECT_NEAR(optics.cutoff(), 2.0 * pi / 625e-9, 1.0);  // λ/(2 NA)
    EXPECT_NEAR(optics.at(0.0), 1.0, 1e-12);
    EXPECT_NEAR(optics.at(0.5 * optics.cutoff()), 2.0 / 3.0 - std::sqrt(3.0) / (2.0 * pi), 1e-12);
    EXPECT_EQ(optics.at(1.1 * optics.cutoff()), 0.0);
}

constexpr double shortest_wavelength = 40e-9;

spectra::SelfAffine model() {
    return {.plateau = 2e-30,
            .rolloff_wavevector = 2.0 * pi / 1e-6,
            .hurst_exponent = 0.8,
            .short_wavevector = 2.0 * pi / shortest_wavelength};
}

topography::HeightMap surface(std::uint64_t seed, Index points, double pixel) {
    const double size = static_cast<double>(points) * pixel;
    return synthesis::random_surface(spectra::density(model()), {points, points, size, size},
                                     {.key = {seed, 1}, .threads = {1}});
}

/// Weighted mean of ln C_iso − ln of the known input between two wavevectors, and its largest size in standard errors.
struct Departure {
    double mean = 0.0, worst = 0.0;
};
Departure departure(const LikelihoodSpectrum& fit, double from, double to) {
    const auto known = spectra::density(model());
    Departure found;
    int n = 0;
    for (Index i = 0; i < fit.C_iso.wavevector.size(); ++i) {
        const double q = fit.C_iso.wavevector[i];
        if (q < from || q > to) continue;
        const double off = std::log(fit.C_iso.density[i] / known(q));
        found.mean += off;
        found.worst = std::max(found.worst, std::abs(off) / fit.log_standard_error[i]);
        ++n;
    }
    found.mean /= n;
    return found;
}

// Lines of maps filtered as by the microscope.
TEST(OpticalTransfer, IsCorrectedByTheFit) {
    const OpticalTransfer optics{.numerical_aperture = 0.3, .light_wavelength = 100e-9};
    std::vector<ObservedSurface> blurred;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        constexpr Index points = 512;
        constexpr double pixel = 20e-9, size = points * pixel;
        const auto filtered = [&](double q) { return spectra::density(model())(q) * std::pow(optics.at(q), 2); };
        const auto patch =
            synthesis::random_surface(filtered, {points, points, size, size}, {.key = {seed, 2}, .threads = {1}});
        topography::HeightMap map{
            patch.heights.topLeftCorner(points / 2, points / 2), {0.5 * size, 0.5 * size}, false, {}};
        map.metadata.instrument.type = "optical";
        blurred.push_back({map, topography::Trend::tilt});
    }
    const LikelihoodOptions options{.shortest_wavelength = shortest_wavelength, .threads = {1}};
    const double from = 0.2 * optics.cutoff(), to = 0.5 * optics.cutoff();
    const auto without = departure(likelihood_spectrum(blurred, options), from, to);
    for (auto& one : blurred) one.optics = optics;
    const auto with = departure(likelihood_spectrum(blurred, options), 0.4 * from, 0.8 * to);
    EXPECT_LT(without.mean, -0.5);
    EXPECT_LT(std::abs(with.mean), 0.1);
    EXPECT_LT(with.worst, 3.5);
}

// Silhouettes of 100 nm of a surface with waves as short as 40 nm, on a grid with few peaks between points.
TEST(Probe, OfAFoilIsCorrectedByTheFit) {
    constexpr Index points = 512, finer = 4, fine = finer * points;
    constexpr double pixel = 10e-9, thickness = 100e-9;
    std::vector<ObservedSurface> contours;
    for (std::uint64_t seed = 100; seed < 116; ++seed) {
        const auto map = surface(seed, fine, pixel / finer);
        for (Index line = 0; line < fine; line += fine / 4) {
            topography::Profile profile{Array1D(points / 2), Array1D(points / 2), {}};
            for (Index i = 0; i < points / 2; ++i) {
                profile.positions[i] = static_cast<double>(i) * pixel;
                double highest = map.heights(finer * i, line);
                for (Index l = 1; l <= 10 * finer; ++l)
                    highest = std::max(highest, map.heights(finer * i, (line + l) % fine));
                profile.heights[i] = highest;
            }
            profile.metadata.instrument.type = "tem";
            contours.push_back({profile, topography::Trend::mean});
        }
    }
    const LikelihoodOptions options{
        .shortest_wavelength = shortest_wavelength, .tip_points = 512, .tip_length = 512, .threads = {1}};
    const auto without = departure(likelihood_spectrum(contours, options), 2e7, 1e8);
    for (auto& one : contours) one.probe = foil({.value = thickness, .standard_error = 10e-9});
    const auto fit = likelihood_spectrum(contours, options);
    const auto with = departure(fit, 2e7, 1e8);
    ASSERT_FALSE(fit.tips.empty());
    EXPECT_EQ(fit.tips.front().probe, "foil, 100 nm");
    EXPECT_LT(without.mean, -0.1);
    EXPECT_LT(std::abs(with.mean), 0.08);
    EXPECT_LT(with.worst, 3.5);
}

// A radius one standard error larger changes the spectrum by the contribution of the error of the radius to its
// variance.
TEST(Probe, OfUncertainSizeWidensIntervalsByItsEffect) {
    constexpr Index points = 512;
    constexpr double pixel = 10e-9, radius = 200e-9, error = 10e-9;
    std::vector<ObservedSurface> scans;
    for (std::uint64_t seed = 200; seed < 206; ++seed) {
        const auto map =
            topography::dilated(surface(seed, points, pixel), topography::SphereTip{radius}, {.threads = {1}});
        for (Index line = 0; line < points; line += points / 4) {
            topography::LineScan scan;
            scan.heights = map.heights.col(line).head(points / 2);
            scan.size = points / 2 * pixel;
            scan.metadata.instrument.type = "stylus";
            scans.push_back({scan, topography::Trend::tilt});
        }
    }
    const auto fit = [&](const Estimate& size) {
        for (auto& one : scans) one.probe = sphere(size);
        return likelihood_spectrum(scans, {.shortest_wavelength = shortest_wavelength,
                                           .tip_band = false,
                                           .tip_points = 512,
                                           .tip_length = 512,
                                           .threads = {1}});
    };
    const auto known = fit({.value = radius}), uncertain = fit({radius, error}),
               larger = fit({.value = radius + error});
    // where T decreases; at its end the fit also responds by another T, which the covariance includes to first order
    double moved = 0.0, added = 0.0;
    for (Index i = 0; i < known.C_iso.wavevector.size(); ++i) {
        const double q = known.C_iso.wavevector[i];
        const double more = std::pow(uncertain.log_standard_error[i], 2) - std::pow(known.log_standard_error[i], 2);
        EXPECT_GT(more, -1e-12) << q;
        if (q < 1.5e7 || q > 4.5e7) continue;
        moved += std::pow(std::log(larger.C_iso.density[i] / known.C_iso.density[i]), 2);
        added += more;
    }
    EXPECT_NEAR(std::sqrt(added / moved), 1.0, 0.25);
}

// Inverted scans have the same periodograms and the opposite skewness: inverting some of them changes the fit by their
// mean skewness and widens its intervals by the scatter of it, and nothing else.
TEST(Probe, OfSkewedHeightsWidensIntervalsByTheEffectOfSkewness) {
    constexpr Index points = 1024;
    constexpr double pixel = 10e-9;
    const auto peaks = synthesis::lognormal_heights(1.0);
    std::vector<ObservedSurface> scans;
    for (std::uint64_t seed = 300; seed < 308; ++seed) {
        auto map = surface(seed, points, pixel);
        const double rms = std::sqrt(map.heights.square().mean());
        map.heights = map.heights.unaryExpr([&](double h) { return rms * peaks(h / rms); });
        map = topography::dilated(map, topography::SphereTip{200e-9}, {.threads = {1}});
        for (Index line = 0; line < points; line += points / 8) {
            topography::LineScan scan;
            scan.heights = map.heights.col(line);
            scan.size = points * pixel;
            scan.metadata.instrument.type = "stylus";
            scans.push_back({.measurement = scan,
                             .trend = topography::Trend::mean,
                             .untouched = {0.0, 4e7},
                             .probe = sphere({.value = 200e-9})});
        }
    }
    const auto fit = [&] {
        return likelihood_spectrum(
            scans,
            {.shortest_wavelength = shortest_wavelength, .tip_points = 1024, .tip_length = 1024, .threads = {1}});
    };
    const auto skewness = [&] {
        Array1D each(static_cast<Index>(scans.size()));
        for (Index i = 0; i < each.size(); ++i) {
            const auto& heights =
                std::get<topography::LineScan>(scans[static_cast<std::size_t>(i)].measurement).heights;
            const Array1D centred = heights - heights.mean();
            each[i] = centred.cube().mean() / std::pow(centred.square().mean(), 1.5);
        }
        const auto n = static_cast<double>(each.size());
        return Estimate{each.mean(), std::sqrt((each - each.mean()).square().sum() / (n * (n - 1.0)))};
    };
    const auto skewed = fit();
    const auto of_skewed = skewness();
    for (std::size_t i = 0; i < scans.size(); i += 6) {
        auto& heights = std::get<topography::LineScan>(scans[i].measurement).heights;
        heights = -heights;
    }
    const auto mixed = fit();
    const auto of_mixed = skewness();
    double moved = 0.0, added = 0.0;
    for (Index i = 0; i < skewed.C_iso.wavevector.size(); ++i) {
        const double q = skewed.C_iso.wavevector[i];
        if (q < 2e6 || q > 2e7) continue;
        moved += std::pow(std::log(mixed.C_iso.density[i] / skewed.C_iso.density[i]), 2);
        added += std::pow(mixed.log_standard_error[i], 2) - std::pow(skewed.log_standard_error[i], 2);
    }
    const double response = std::sqrt(moved) / std::abs(of_mixed.value - of_skewed.value);
    const double scatter = std::sqrt(of_mixed.variance() - of_skewed.variance());
    EXPECT_GT(response, 0.0);
    EXPECT_NEAR(std::sqrt(added) / scatter / response, 1.0, 0.25);
}

TEST(Probe, OfAnExactSizeHasNoError) {
    EXPECT_EQ(foil(Estimate{.value = 20e-9}).size_error, 0.0);
    EXPECT_EQ(sphere(Estimate{.value = 20e-9}).size_error, 0.0);
    EXPECT_EQ(foil({20e-9, 3e-9}).size_error, 3e-9);
}

}  // namespace
}  // namespace setae::spectral_fit::probe_test
