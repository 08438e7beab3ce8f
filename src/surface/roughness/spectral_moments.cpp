// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/spectral_moments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "cut_moments.hpp"
#include "mode_parts.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "straight_line.hpp"

namespace setae::roughness {
namespace {

/// C = level · (q/left)^exponent between two wavevectors; or, if `mode` is not 0, the cell of the mode at that
/// wavevector, with the constant integrand of the mode.
struct Piece {
    double left, right, level, exponent, mode = 0.0;
};

/// Cells of modes: each extends half way to its neighbours, the outer ones to the ends of the band.
std::vector<Piece> cells(const std::vector<double>& q, const std::vector<double>& c, const Band& band) {
    std::vector<Piece> result;
    result.reserve(q.size());
    for (std::size_t i = 0; i < q.size(); ++i) {
        const double left = i == 0 ? band.lower : 0.5 * (q[i - 1] + q[i]);
        const double right = i + 1 == q.size() ? band.upper : 0.5 * (q[i] + q[i + 1]);
        const double from = std::max(left, band.lower), to = std::min(right, band.upper);
        if (from < to) result.push_back({from, to, c[i], 0.0, q[i]});
    }
    return result;
}

/// Nodes with a value.
struct Usable {
    std::vector<double> q, c;
};

Usable usable_nodes(const spectra::Spectrum& curve) {
    const bool modes = curve.nodes == spectra::Nodes::modes;
    Usable found;
    for (Index i = 0; i < curve.wavevector.size(); ++i)
        if (std::isfinite(curve.density[i]) && (modes || curve.density[i] > 0.0)) {
            found.q.push_back(curve.wavevector[i]);
            found.c.push_back(curve.density[i]);
        }
    if (found.q.size() < 2)
        throw UndefinedDataError(
            fmt::format("a spectrum with {} usable values cannot be integrated; expected at least 2", found.q.size()));
    return found;
}

/// Exponent of C1D over the last third of a decade, at most −1.01: the power of lines on a surface decreases with
/// wavelength.
double last_exponent(const Usable& nodes) {
    constexpr double part = 2.15, flattest = -1.01;
    const double last = nodes.q.back();
    std::size_t first = nodes.q.size() - 2;
    while (first > 0 && nodes.q[first] > last / part) --first;
    std::vector<double> x, y;
    for (std::size_t i = first; i < nodes.q.size(); ++i) {
        x.push_back(std::log(nodes.q[i]));
        y.push_back(std::log(nodes.c[i]));
    }
    return std::min(flattest, line_through(x, y).slope);
}

/// Power laws between nodes, the outer ones up to the ends of the band if these are beyond.
std::vector<LinePiece> power_laws(const Usable& nodes, const Band& band) {
    const auto& [q, c] = nodes;
    std::vector<LinePiece> result;
    for (std::size_t i = 0; i + 1 < q.size(); ++i) {
        const double exponent = std::log(c[i + 1] / c[i]) / std::log(q[i + 1] / q[i]);
        const double left = i == 0 ? std::min(q[0], band.lower) : q[i];
        const double right = i + 2 == q.size() ? std::max(q[i + 1], band.upper) : q[i + 1];
        result.push_back({left, right, c[i] * std::pow(left / q[i], exponent), exponent});
    }
    return result;
}

/// C1D as power laws from below the band to the end of the waves of the surface.
std::vector<LinePiece> line_pieces(const spectra::Spectrum& curve) {
    const auto nodes = usable_nodes(curve);
    auto result = power_laws(nodes, curve.band);
    const auto& last = result.back();
    if (last.right < curve.waves_end * (1.0 - 1e-9)) {
        const double end = last.level * std::pow(last.right / last.left, last.exponent);
        result.push_back({last.right, curve.waves_end, end, last_exponent(nodes)});
    }
    return result;
}

/// A curve as pieces that cover its band, in order.
std::vector<Piece> pieces(const spectra::Spectrum& curve) {
    const auto& band = curve.band;
    const auto nodes = usable_nodes(curve);
    if (curve.nodes == spectra::Nodes::modes) return cells(nodes.q, nodes.c, band);
    std::vector<Piece> result;
    for (const auto& law : power_laws(nodes, band)) {
        const double from = std::max(law.left, band.lower), to = std::min(law.right, band.upper);
        if (from < to) result.push_back({from, to, law.level * std::pow(from / law.left, law.exponent), law.exponent});
    }
    return result;
}

/// ∫ q^order C dq over one piece, without cancellation if order + exponent is near −1.
double integral(const Piece& piece, double order) {
    if (piece.mode > 0.0) return piece.level * std::pow(piece.mode, order) * (piece.right - piece.left);
    const double s = piece.exponent + order + 1.0;
    const double log_ratio = std::log(piece.right / piece.left);
    const double growth =
        std::abs(s * log_ratio) < 1e-8 ? log_ratio * (1.0 + 0.5 * s * log_ratio) : std::expm1(s * log_ratio) / s;
    return piece.level * std::pow(piece.left, order + 1.0) * growth;
}

/// The integral weighted with 1/√(1 − (q/q_s)²): q = q_s sin t removes the singularity at q_s.
double weighted_integral(const Piece& piece, double order, double q_s) {
    const double t0 = std::asin(std::min(1.0, piece.left / q_s)), t1 = std::asin(std::min(1.0, piece.right / q_s));
    if (piece.mode > 0.0) return piece.level * std::pow(piece.mode, order) * q_s * (t1 - t0);
    const auto integrand = [&](double t) {
        const double q = q_s * std::sin(t);
        return q_s * std::pow(q, order) * piece.level * std::pow(q / piece.left, piece.exponent);
    };
    return boost::math::quadrature::gauss<double, 15>::integrate(integrand, t0, t1);
}

/// Contributions of C1D through the exact identities.
Contribution of_profile(const Piece& piece) {
    return {integral(piece, 0.0) / pi, 2.0 * integral(piece, 2.0) / pi, 2.0 * integral(piece, 4.0) / (3.0 * pi),
            integral(piece, 1.0) / 8.0};
}

/// Contributions of C_iso; integrate(order) is ∫ q^order C_iso dq.
template <class Integrate>
Contribution of_isotropic(Integrate integrate) {
    return {integrate(1.0) / (2.0 * pi), integrate(3.0) / (2.0 * pi), integrate(5.0) / (8.0 * pi),
            integrate(2.0) / (8.0 * pi)};
}

Contribution contribution(const Piece& piece, const spectra::Spectrum& curve, Conversion conversion) {
    if (curve.kind == spectra::Density::C_iso)
        return of_isotropic([&](double order) { return integral(piece, order); });
    if (conversion == Conversion::exact) return of_profile(piece);
    return of_isotropic([&](double order) { return pi * weighted_integral(piece, order - 1.0, curve.band.upper); });
}

/// ∫ ln C d(ln q) over the part of a piece between two wavevectors.
double log_integral(const Piece& piece, double lower, double upper) {
    const double from = std::log(std::max(piece.left, lower) / piece.left),
                 to = std::log(std::min(piece.right, upper) / piece.left);
    return to > from ? (to - from) * (std::log(piece.level) + 0.5 * piece.exponent * (from + to)) : 0.0;
}

DecadeMeans means_of(const std::vector<Piece>& parts) {
    constexpr double rounding = 1e-9;
    DecadeMeans means = no_decades;
    for (std::size_t d = 0; d < means.size(); ++d) {
        const double lower = std::pow(10.0, first_decade + static_cast<double>(d)), upper = 10.0 * lower;
        if (parts.empty() || parts.front().left > lower * (1.0 + rounding) ||
            parts.back().right < upper * (1.0 - rounding))
            continue;
        double sum = 0.0;
        for (const auto& piece : parts) sum += log_integral(piece, lower, upper);
        means[d] = std::exp(sum / std::log(10.0));
    }
    return means;
}

}  // namespace

spectra::Spectrum limited(spectra::Spectrum curve, const WavelengthLimits& limits) {
    if (limits.longest) curve.band.lower = std::max(curve.band.lower, 2.0 * pi / *limits.longest);
    if (limits.shortest) curve.band.upper = std::min(curve.band.upper, 2.0 * pi / *limits.shortest);
    if (!(curve.band.lower < curve.band.upper))
        throw InvalidArgument(
            fmt::format("no wavevector between {:.4g} and {:.4g} 1/m is left; increase longest_wavelength or reduce "
                        "shortest_wavelength",
                        curve.band.lower, curve.band.upper));
    return curve;
}

Array1D values_at(const spectra::Spectrum& curve, const ArrayView1D& wavevector) {
    const auto parts = pieces(curve);
    Array1D values = Array1D::Constant(wavevector.size(), undefined);
    for (Index i = 0; i < wavevector.size(); ++i) {
        const double q = wavevector[i];
        const auto piece = std::find_if(parts.begin(), parts.end(), [q](const Piece& p) { return q <= p.right; });
        if (piece != parts.end() && q >= piece->left)
            values[i] = piece->level * std::pow(q / piece->left, piece->exponent);
    }
    return values;
}

namespace {

/// Whether the waves of a curve of lines can be separated from contributions of shorter ones: not for single modes.
bool can_be_cut(const spectra::Spectrum& curve) {
    return curve.kind == spectra::Density::C1D && curve.nodes != spectra::Nodes::modes;
}

/// If C1D rises by scatter, no isotropic surface has it and a moment may be negative.
SpectralParameters parameters_of(const CutMoments& moments) {
    const auto root = [](double square) { return std::sqrt(std::max(0.0, square)); };
    return {root(moments.first / (2.0 * pi)), root(moments.third / (2.0 * pi)), root(moments.fifth / (8.0 * pi)),
            std::max(0.0, moments.second / (8.0 * pi))};
}

/// Values that decrease by scatter, made increasing to the last.
void make_rising(Array1D& values) {
    const Index n = values.size();
    for (Index i = 1; i < n; ++i) values[i] = std::min(values[n - 1], std::max(values[i - 1], values[i]));
}

}  // namespace

double SpectralParameters::area_ratio() const { return 1.0 + area_shape * (gaussian_area_ratio(rms_slope) - 1.0); }

SpectralParameters spectral_parameters(const spectra::Spectrum& curve, Conversion conversion) {
    const auto parts = pieces(curve);
    SpectralParameters parameters;
    if (can_be_cut(curve) && conversion == Conversion::exact) {
        parameters = parameters_of(cut_moments(line_pieces(curve), curve.band));
    } else {
        Contribution sum;
        for (const auto& piece : parts) sum += contribution(piece, curve, conversion);
        parameters = sum.parameters();
    }
    if (curve.kind == spectra::Density::C1D) parameters.decade_C1D = means_of(parts);
    return parameters;
}

std::vector<ModePart> mode_parts(const spectra::Spectrum& modes, Conversion conversion) {
    const auto parts = pieces(modes);
    std::vector<ModePart> result;
    result.reserve(parts.size());
    for (const auto& piece : parts)
        result.push_back({piece.mode, piece.level, piece.left, piece.right, contribution(piece, modes, conversion)});
    return result;
}

DecadeMeans decade_means(const spectra::Spectrum& C1D) { return means_of(pieces(C1D)); }

CumulativeParameters cumulative_parameters(const spectra::Spectrum& curve) {
    const auto parts = pieces(curve);
    const auto n = static_cast<Index>(parts.size()) + 1;
    CumulativeParameters result{Array1D(n), Array1D(n), Array1D(n), Array1D(n), Array1D(n)};
    const bool cut = can_be_cut(curve);
    const auto lines = cut ? line_pieces(curve) : std::vector<LinePiece>();
    Contribution sum;
    for (Index i = 0; i < n; ++i) {
        const auto* piece = i > 0 ? &parts[static_cast<std::size_t>(i - 1)] : nullptr;
        result.wavevector[i] = piece ? piece->right : parts.front().left;
        if (piece && !cut) sum += contribution(*piece, curve, Conversion::exact);
        const auto parameters =
            piece && cut ? parameters_of(cut_moments(lines, {parts.front().left, piece->right})) : sum.parameters();
        result.rms_height[i] = parameters.rms_height;
        result.rms_slope[i] = parameters.rms_slope;
        result.rms_curvature[i] = parameters.rms_curvature;
        result.elastic_energy_per_modulus[i] = parameters.elastic_energy_per_modulus;
    }
    if (cut)
        for (auto* values :
             {&result.rms_height, &result.rms_slope, &result.rms_curvature, &result.elastic_energy_per_modulus})
            make_rising(*values);
    return result;
}

}  // namespace setae::roughness
