// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing.hpp"
#include "setae/core/uncertain_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace setae::study_figures {

Array1D array_of(const std::vector<double>& values) {
    return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
}

DrawnCurve log_means(const DrawnCurve& curve, Index most) {
    if (curve.x.size() <= most) return curve;
    const double first = std::log(curve.x[0]),
                 step = (std::log(curve.x[curve.x.size() - 1]) - first) / static_cast<double>(most);
    std::vector<double> x, y;
    for (Index i = 0; i < curve.x.size();) {
        const auto bin = [&](Index k) {
            return std::min(static_cast<Index>((std::log(curve.x[k]) - first) / step), most - 1);
        };
        const Index here = bin(i);
        double log_x = 0.0, sum = 0.0, n = 0.0;
        for (; i < curve.x.size() && bin(i) == here; ++i) {
            if (!std::isfinite(curve.y[i])) continue;
            log_x += std::log(curve.x[i]);
            sum += curve.y[i];
            n += 1.0;
        }
        if (n == 0.0) continue;
        x.push_back(std::exp(log_x / n));
        y.push_back(sum / n);
    }
    return {array_of(x), array_of(y)};
}

std::vector<Index> thinned(const Array1D& x, const Array1D& y, Index first, Index last, Index most) {
    std::vector<Index> samples;
    const Index n = last - first + 1;
    if (n <= 0) return samples;
    const Index stride = (n + most - 1) / most;
    const auto spread = [&](const Array1D& values) {
        const auto part = values.segment(first, n);
        const double least = part.isFinite().select(part, HUGE_VAL).minCoeff(),
                     largest = part.isFinite().select(part, -HUGE_VAL).maxCoeff();
        return largest > least ? largest - least : 1.0;
    };
    const double x_spread = spread(x), y_spread = spread(y);
    constexpr double jump = 0.03;
    const auto jumps = [&](Index i) {
        return std::hypot((x[i + 1] - x[i]) / x_spread, (y[i + 1] - y[i]) / y_spread) > jump;
    };
    for (Index i = first; i <= last; ++i)
        if ((i - first) % stride == 0 || i == last || jumps(i) || (i > first && jumps(i - 1))) samples.push_back(i);
    return samples;
}

Array1D taken(const Array1D& values, const std::vector<Index>& samples) {
    Array1D result(static_cast<Index>(samples.size()));
    for (std::size_t i = 0; i < samples.size(); ++i) result[static_cast<Index>(i)] = values[samples[i]];
    return result;
}

std::span<const study::SurfaceResult> drawn_surfaces(const study::StudyResult& result) {
    constexpr std::size_t most = 100;
    return std::span(result.surfaces).first(std::min(most, result.surfaces.size()));
}

std::string left_out_surfaces(const study::StudyResult& result) {
    const auto shown = drawn_surfaces(result).size(), all = result.surfaces.size();
    return shown == all ? "" : fmt::format(" The figure shows the first {} of {} surfaces.", shown, all);
}

int colour_of_place(std::size_t place) {
    constexpr std::array colours{colour::blue, colour::vermilion, colour::green,
                                 colour::pink, colour::orange,    colour::sky};
    return colours[place % colours.size()];
}

std::size_t place_of_surface(const study::StudyResult& result, const std::string& name) {
    return static_cast<std::size_t>(&result.surface(name) - result.surfaces.data());
}

std::size_t place_of_elastomer(const study::StudyResult& result, const std::string& name) {
    return static_cast<std::size_t>(&result.elastomer(name) - result.elastomers.data());
}

std::string label_of(const study::SurfaceResult& surface) {
    return surface.name + (surface.reconstructed ? " (reconstruction)" : "");
}

std::string instrument_in_words(const std::string& type) {
    if (type == "afm" || type == "tem") return type == "afm" ? "AFM" : "TEM";
    return type.empty() || type == "unknown" ? "unknown instrument" : type;
}

std::string instrument_of(const study::MeasurementResult& measurement) {
    const auto& instrument = measurement.spectrum.metadata.instrument;
    return instrument_in_words(!instrument.type.empty() ? instrument.type : instrument.name);
}

std::vector<InstrumentBand> instrument_bands(const std::vector<const study::SurfaceResult*>& surfaces) {
    std::vector<InstrumentBand> found;
    for (const auto* surface : surfaces)
        for (const auto& m : surface->measurements) {
            if (m.failed() || !(m.spectrum.band.upper > m.spectrum.band.lower)) continue;
            const auto name = instrument_of(m);
            auto known = std::find_if(found.begin(), found.end(),
                                      [&](const InstrumentBand& other) { return other.instrument == name; });
            if (known == found.end())
                known = found.insert(found.end(), {name, {m.spectrum.band.lower, m.spectrum.band.upper}});
            known->band = {std::min(known->band.lower, m.spectrum.band.lower),
                           std::max(known->band.upper, m.spectrum.band.upper)};
        }
    std::stable_sort(found.begin(), found.end(),
                     [](const InstrumentBand& a, const InstrumentBand& b) { return a.band.lower < b.band.lower; });
    return found;
}

std::string with_error(const Estimate& estimate, double factor, const std::string& unit) {
    return uncertain_number(estimate, 1.0 / factor) + " " + unit;
}

std::string reconstruction_note(const study::StudyResult& result) {
    std::string names;
    for (const auto& surface : drawn_surfaces(result))
        if (surface.reconstructed) names += (names.empty() ? "" : ", ") + surface.name;
    if (names.empty()) return {};
    return " Reconstruction: the spectrum of " + names +
           " is self-affine, with the three published moments (rms height, slope and curvature). All other properties, also the "
           "stored energy, follow from this model.";
}

std::string floored_note(const study::StudyResult& result) {
    std::string pairs;
    for (const auto& pair : result.pairs) {
        if (!pair.modified || !pair.approach || !result.surface(pair.surface).reconstructed) continue;
        // adhesion was measured beyond two standard errors
        if (pair.modified->work.conforms || !(pair.approach->value > 2.0 * std::sqrt(pair.approach->variance())))
            continue;
        const auto& elastomer = result.elastomer(pair.elastomer);
        const double r = pair.area_ratio;
        const double most = (result.work_of_adhesion->value * r - elastomer.input.surface_energy.value * (r - 1.0)) /
                            elastomer.contact_modulus.value;
        pairs += fmt::format("{}{} on {} (measured {}; {:.2f} nm, not {:.2f} nm)", pairs.empty() ? "" : ", ",
                             pair.surface, pair.elastomer, with_error(*pair.approach, 1e3, "mJ/m2"), 1e9 * most,
                             1e9 * pair.stored_energy.value / elastomer.contact_modulus.value);
    }
    if (pairs.empty()) return {};
    return fmt::format(
        " With this spectrum, the full-contact balance (Eq. 7) predicts 0 for pairs with measured adhesion. Eq. 7 with W_int = {:.1f} mJ/m2 requires U_el/(A_app E*) of the surface "
        "below the first length: {}.",
        1e3 * result.work_of_adhesion->value, pairs);
}

std::string counted(std::size_t n, const std::string& thing) {
    return n == 1 ? "one " + thing : fmt::format("{} {}s", n, thing);
}

}  // namespace setae::study_figures
