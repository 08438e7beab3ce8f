// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/contour_trials.hpp"

#include <algorithm>
#include <filesystem>
#include <mutex>

#include <fmt/format.h>

#include "contour_comparison.hpp"
#include "contour_picture.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::validation {
namespace {

std::vector<ContourKind> chosen_kinds(const ContourTrialOptions& options) {
    const auto all = contour_kinds(options.size);
    if (options.kinds.empty()) return all;
    std::vector<ContourKind> chosen;
    for (const auto& name : options.kinds) {
        const auto kind = std::find_if(all.begin(), all.end(), [&](const ContourKind& k) { return k.name == name; });
        if (kind == all.end()) {
            std::string names;
            for (const auto& k : all) names += (names.empty() ? "'" : ", '") + k.name + "'";
            throw InvalidArgument(fmt::format("no kind of picture '{}'; expected one of {}", name, names));
        }
        chosen.push_back(*kind);
    }
    return chosen;
}

struct Rendered {
    imaging::FramePixels pixels;
    RenderedContour contour;
};

Rendered rendered(const ContourKind& kind, const ContourTrialOptions& options, std::uint64_t run) {
    enum Stream : std::uint64_t { curve_stream, picture_stream };
    auto curve = kind.curve;
    curve.width = curve.height = options.size;
    curve.key = {options.first_seed + run, curve_stream};
    auto picture = kind.picture;
    picture.width = picture.height = options.size;
    picture.key = {options.first_seed + run, picture_stream};
    Rendered result{{}, {simulation::rough_curve(curve), options.size, options.size, curve.cutoff_wavelength}};
    result.pixels = simulation::render_micrograph(result.contour.truth.curve, picture);
    if (kind.transposed) {
        result.pixels = imaging::FramePixels(result.pixels.transpose());
        auto& truth = result.contour.truth;
        // mirrored at the diagonal, with the sample to the right: the vacuum is on the left of the upward direction of
        // the picture's columns
        std::swap(truth.curve.x, truth.curve.y);
        truth.curve.x.reverseInPlace();
        truth.curve.y.reverseInPlace();
        for (auto& overhang : truth.overhangs) std::swap(overhang.x, overhang.y);
    }
    return result;
}

ContourTrial trial_of(const ContourKind& kind, const ContourTrialOptions& options, int run) {
    const auto picture = rendered(kind, options, static_cast<std::uint64_t>(run));
    ContourTrial trial;
    imaging::ContourTrace trace;
    try {
        trace = options.tracer(picture.pixels);
        trial = compared(trace, picture.contour);
    } catch (const UndefinedDataError& refused) {
        trial.refusal = refused.what();
    }
    trial.run = run;
    trial.kind = kind.name;
    trial.judged = kind.judged;
    if (!options.pictures.empty())
        write_contour_picture(options.pictures, trial, picture.pixels, picture.contour.truth.curve, trace);
    return trial;
}

}  // namespace

std::vector<ContourKind> contour_kinds(long size) {
    const simulation::RoughCurveOptions curve{.rms_height = 16.0,
                                              .hurst_exponent = 0.8,
                                              .rolloff_wavelength = static_cast<double>(size),
                                              .cutoff_wavelength = 10.0};
    const auto picture = [](double signal_to_noise) {
        return simulation::MicrographOptions{.noise = signal_to_noise > 0.0 ? 1.0 / signal_to_noise : 0.0};
    };
    std::vector<ContourKind> kinds{
        {"clean", curve, picture(0.0)}, {"SNR 5", curve, picture(5.0)}, {"SNR 2", curve, picture(2.0)}};
    auto fringe = picture(2.0), drift = picture(2.0), lattice = picture(2.0), texture = picture(3.0);
    fringe.fringe_amplitude = 0.3;
    drift.drift = 0.5;
    lattice.lattice_amplitude = 0.3;
    texture.texture = 0.15;
    kinds.push_back({"SNR 2 + fringe", curve, fringe});
    kinds.push_back({"SNR 2 + drift", curve, drift});
    kinds.push_back({"SNR 2 + lattice", curve, lattice});
    kinds.push_back({"SNR 3 + texture", curve, texture});
    auto overhanging = curve, tilted = curve, fine = curve;
    overhanging.rms_height = 8.0;
    overhanging.bulges = static_cast<int>(size / 125);
    tilted.tilt = 20.0 * pi / 180.0;
    fine.cutoff_wavelength = 3.0;
    kinds.push_back({.name = "SNR 2 + overhangs", .curve = overhanging, .picture = picture(2.0)});
    kinds.push_back({"SNR 2, tilted 20 deg", tilted, picture(2.0)});
    kinds.push_back({.name = "SNR 2, upright", .curve = curve, .picture = picture(2.0), .transposed = true});
    for (const auto& [name, signal_to_noise] :
         {std::pair{"clean, waves to 3 px", 0.0}, {"SNR 5, waves to 3 px", 5.0}, {"SNR 2, waves to 3 px", 2.0}})
        kinds.push_back({.name = name, .curve = fine, .picture = picture(signal_to_noise), .judged = false});
    return kinds;
}

std::vector<ContourTrial> contour_trials(const ContourTrialOptions& options) {
    if (options.runs < 1 || options.size < 200)
        throw InvalidArgument(fmt::format("{} runs of pictures {} px wide; expected at least 1 of at least 200 px",
                                          options.runs, options.size));
    if (!options.tracer) throw InvalidArgument("no tracer; expected a function that traces a picture");
    const auto kinds = chosen_kinds(options);
    if (!options.pictures.empty()) {
        std::error_code ignored;  // a folder that cannot be made gives an error on writing
        std::filesystem::create_directories(options.pictures, ignored);
    }
    const auto runs = static_cast<std::size_t>(options.runs);
    std::vector<ContourTrial> trials(runs * kinds.size());
    std::mutex telling;
    int done = 0;
    parallel::for_each_index(trials.size(), options.threads, [&](std::size_t i) {
        trials[i] = trial_of(kinds[i / runs], options, static_cast<int>(i % runs));
        const std::scoped_lock lock(telling);
        if (options.progress) options.progress(++done);
    });
    return trials;
}

}  // namespace setae::validation
