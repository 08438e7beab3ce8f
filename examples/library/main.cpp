// SPDX-License-Identifier: GPL-3.0-or-later
// works_of_adhesion MAP LOOP: what a map says of adhesion, beside what a loop on it measured.
//
// The sphere is of PDMS, 1.25 mm in radius; the works of adhesion come out of balance (7) of Dalvi et al., PNAS 116
// (2019) 25484, and out of Johnson, Kendall and Roberts' fit to the loading branch. All quantities are SI.
#include <cstdio>
#include <exception>
#include <limits>
#include <variant>

#include <setae/adhesion/stored_energy.hpp>
#include <setae/adhesion/work_of_adhesion.hpp>
#include <setae/formats/channel.hpp>
#include <setae/loops/analysis.hpp>
#include <setae/roughness/spectral_moments.hpp>
#include <setae/roughness/true_area.hpp>
#include <setae/spectra/power_spectrum.hpp>
#include <setae/tables/loop_file.hpp>

namespace {

constexpr double intrinsic_work = 0.037;  // W_int [J/m²]
constexpr double surface_energy = 0.025;  // γ1 [J/m²]
constexpr double radius = 1.25e-3;        // R [m]

setae::loops::LoopAnalysis measured(const char* file) {
    const auto loop = setae::loops::loop_from_table(setae::tables::read_loop(file));
    setae::loops::LensAndCounterBody bodies;
    bodies.radius = radius;
    bodies.counter_youngs_modulus = std::numeric_limits<double>::infinity();
    return setae::loops::analyse(loop, bodies);
}

double predicted(const char* file, double contact_modulus) {
    const auto measurement = setae::formats::read(file);
    const auto moments = setae::roughness::spectral_parameters(setae::spectra::power_spectrum(measurement));
    std::printf("h_rms %.3g m, slope %.3g, curvature %.3g 1/m\n", moments.rms_height, moments.rms_slope,
                moments.rms_curvature);
    const setae::adhesion::ConformalState conforming{
        .area_ratio = setae::roughness::gaussian_area_ratio(moments.rms_slope),
        .stored_energy = contact_modulus * moments.elastic_energy_per_modulus,
    };
    return setae::adhesion::modified_balance(intrinsic_work, surface_energy, conforming).floored;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "works_of_adhesion MAP LOOP\n");
        return 2;
    }
    try {
        const auto loop = measured(argv[2]);
        const auto& fit = loop.loading.primary();
        std::printf("E* %.3g Pa, W %.3g J/m2 on loading\n", fit.contact_modulus.value, fit.work_of_adhesion.value);
        std::printf("W %.3g J/m2 predicted\n", predicted(argv[1], fit.contact_modulus.value));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
