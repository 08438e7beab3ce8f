// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectrum_convention.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/header.hpp"

namespace setae::tables {
namespace {

constexpr const char *wavevector = "wavevector", *frequency = "frequency", *wavelength = "wavelength";

/// A name without case, accents, markup ("W<sub>1</sub>") and signs: "c1d", "w1", "spatialfrequency".
std::string bare(const std::string& name) {
    static constexpr std::array<std::pair<std::string_view, char>, 3> subscripts{{{"₁", '1'}, {"₂", '2'}, {"ᵣ", 'r'}}};
    const auto lower = folded(name);
    std::string result;
    for (std::size_t i = 0; i < lower.size(); ++i) {
        if (lower[i] == '<') {
            const auto end = lower.find('>', i);
            if (end != std::string::npos) i = end;
            continue;
        }
        for (const auto& [sign, digit] : subscripts)
            if (std::string_view(lower).substr(i).starts_with(sign)) result += digit;
        if ((lower[i] >= 'a' && lower[i] <= 'z') || (lower[i] >= '0' && lower[i] <= '9')) result += lower[i];
    }
    return result;
}

bool is_any(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), text) != words.end();
}

bool holds_any(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

/// All text above the numbers and in the names, for words on the normalisation of a density.
std::string all_words(const RawTable& table) {
    std::string text;
    for (const auto& line : table.header) text += line + "\n";
    for (const auto& column : table.columns) text += column.name + "\n";
    return folded(text);
}

/// "one", "two", or empty if no word states it.
std::string sides_in(const std::string& text) {
    std::string plain;
    for (const char c : text)
        if (c != '-' && c != ' ' && c != '_') plain += c;
    if (holds_any(plain, {"onesided", "singlesided", "1sided", "einseitig", "unilateral", "monolateral"})) return "one";
    if (holds_any(plain, {"twosided", "doublesided", "2sided", "zweiseitig", "bilateral"})) return "two";
    return "";
}

/// Quantity of the first column by its unit and name; empty if both a wavevector and a frequency are possible.
std::string quantity_of(const RawTable::RawColumn& column) {
    if (is_unit_of(column.unit, dimension::length)) return wavelength;
    const auto unit = folded(column.unit), name = bare(column.name);
    if (holds_any(unit, {"rad"}) || holds_any(name, {"angular", "kreisfreq", "rad"})) return wavevector;
    if (holds_any(unit, {"cyc", "lp/"}) || holds_any(name, {"freq", "frec", "cycles"}) ||
        is_any(name, {"f", "fx", "fy", "nu", "1lambda", "1wavelength"}) || folded(column.name) == "ν" ||
        folded(column.name) == "1/λ")
        return frequency;
    if (is_any(name, {"k", "kx", "ky", "kr"}) ||
        holds_any(name, {"wavenumber", "wellenzahl", "nombredonde", "numerodeonda"}))
        return "";
    return wavevector;
}

struct NamedDensity {
    const char* name;
    DensityKind kind;
};

/// The kind by the name of a density.
std::optional<NamedDensity> density_named(std::string_view name, bool areal) {
    if (areal) {
        if (is_any(name, {"c", "ciso", "c2d", "c2diso", "cq", "c2"})) return NamedDensity{"C_iso", DensityKind::areal};
        if (is_any(name, {"w", "w2", "w2d"})) return NamedDensity{"W2", DensityKind::areal_per_wavevector};
        return std::nullopt;
    }
    if (is_any(name, {"c", "c1d", "c1", "cq", "c1dq", "c1dx", "c1dy"}))
        return NamedDensity{"C1D", DensityKind::per_cycle};
    if (is_any(name, {"w1", "w1d", "wx", "wy"})) return NamedDensity{"W1", DensityKind::per_wavevector};
    if (is_any(name, {"wr", "wrad"})) return NamedDensity{"Wr", DensityKind::radial};
    return std::nullopt;
}

/// The kind by a name of several words: "one-sided C1D". A single letter counts only as a whole name.
std::optional<NamedDensity> density_among(const std::string& name, bool areal) {
    if (const auto whole = density_named(bare(name), areal)) return whole;
    for (std::size_t at = 0; at < name.size();) {
        const auto end = std::min(name.find(' ', at), name.size());
        if (const auto word = bare(name.substr(at, end - at)); word.size() > 1)
            if (const auto found = density_named(word, areal)) return found;
        at = end + 1;
    }
    return std::nullopt;
}

/// The kind by the program that wrote the table, if it is stated.
std::optional<NamedDensity> density_of_program(const std::string& words, std::string_view name, bool areal) {
    if (holds_any(words, {"contact.engineering", "topobank", "surfacetopography"}))
        return areal ? NamedDensity{"C_iso", DensityKind::areal} : NamedDensity{"C1D", DensityKind::per_cycle};
    const bool gwyddion = holds_any(words, {"gwyddion"}) || holds_any(name, {"psdf"});
    if (!gwyddion) return std::nullopt;
    if (areal) return NamedDensity{"W2", DensityKind::areal_per_wavevector};
    return holds_any(words, {"radial"}) ? NamedDensity{"Wr", DensityKind::radial}
                                        : NamedDensity{"W1", DensityKind::per_wavevector};
}

/// All readings of a density with an uninformative name, for a quantity.
std::vector<SpectrumConvention> readings(const std::string& quantity, bool areal, const std::string& sides) {
    if (areal && quantity == wavevector)
        return {{quantity, DensityKind::areal, false, "C_iso"},
                {quantity, DensityKind::areal_per_wavevector, false, "W2"}};
    if (areal) return {{quantity, DensityKind::areal, false, "C_iso"}};
    std::vector<SpectrumConvention> all;
    for (const bool one_sided : {false, true}) {
        if (sides == (one_sided ? "two" : "one")) continue;
        all.push_back({quantity, DensityKind::per_cycle, one_sided, "C1D"});
        if (quantity == wavevector) all.push_back({quantity, DensityKind::per_wavevector, one_sided, "W1"});
    }
    return all;
}

}  // namespace

bool SpectrumConvention::own() const {
    return quantity == wavevector && !one_sided && !density.empty() &&
           (kind == DensityKind::per_cycle || kind == DensityKind::areal);
}

ConvertedSpectrum converted(const SpectrumConvention& convention, const Array1D& abscissa) {
    ConvertedSpectrum result;
    result.areal = convention.areal() || convention.kind == DensityKind::radial;
    result.wavevector = convention.quantity == wavelength  ? Array1D(2.0 * pi / abscissa)
                        : convention.quantity == frequency ? Array1D(2.0 * pi * abscissa)
                                                           : abscissa;
    const double sides = convention.one_sided ? 0.5 : 1.0;
    const auto constant = [&](double factor) { return Array1D(Array1D::Constant(abscissa.size(), sides * factor)); };
    switch (convention.kind) {
        case DensityKind::per_cycle:
        case DensityKind::areal: result.factor = constant(1.0); break;
        case DensityKind::per_wavevector: result.factor = constant(2.0 * pi); break;
        case DensityKind::areal_per_wavevector: result.factor = constant(4.0 * pi * pi); break;
        case DensityKind::radial: result.factor = 2.0 * pi / result.wavevector; break;
    }
    return result;
}

double rms_height(const Array1D& q, const Array1D& density, bool areal) {
    // h_rms² = (1/π) ∫ C1D dq = (1/2π) ∫ q C_iso dq; with g = C1D or q C_iso/2 the same integral. C1D of a surface
    // without longer waves is constant below the first wavevector.
    const Array1D g = areal ? Array1D(0.5 * q * density) : density;
    double sum = areal || q.size() == 0 ? 0.0 : q[0] * g[0];
    for (Index i = 1; i < q.size(); ++i) {
        const double a = q[i - 1], b = q[i], ga = g[i - 1], gb = g[i];
        if (!(b > a) || !std::isfinite(ga + gb)) continue;
        if (!(a > 0.0 && ga > 0.0 && gb > 0.0)) {
            sum += 0.5 * (b - a) * (ga + gb);
            continue;
        }
        const double power = 1.0 + std::log(gb / ga) / std::log(b / a);
        sum += std::abs(power) < 1e-9 ? a * ga * std::log(b / a) : (b * gb - a * ga) / power;
    }
    return std::sqrt(sum / pi);
}

std::vector<SpectrumConvention> possible_conventions(const RawTable& table, const SpectrumUnits& stated) {
    const auto words = all_words(table);
    const bool areal = is_unit_of(table.columns[1].unit, dimension::power_spectrum_2d);
    const auto& name = stated.kind.empty() ? table.columns[1].name : stated.kind;
    const auto sides = stated.sides.empty() ? sides_in(words) : stated.sides;
    auto quantity = stated.quantity.empty() ? quantity_of(table.columns[0]) : stated.quantity;
    auto density = density_among(name, areal);
    if (!density && !stated.kind.empty())
        throw InvalidArgument(fmt::format("'{}' is not a density in {}; expected {}", stated.kind,
                                          table.columns[1].unit, areal ? "C_iso or W2" : "C1D, W1 or Wr"));
    if (!density && stated.empty()) density = density_of_program(words, bare(name), areal);
    const bool of_wavevector =
        density && density->kind != DensityKind::per_cycle && density->kind != DensityKind::areal;
    if (quantity.empty() && (density || !stated.empty())) quantity = wavevector;
    if (density && !(of_wavevector && quantity != wavevector))
        return {{quantity, density->kind, sides == "one", density->name}};
    // without further options C1D of both signs
    if (!stated.empty()) return {{quantity, areal ? DensityKind::areal : DensityKind::per_cycle, sides == "one", ""}};
    if (!quantity.empty()) return readings(quantity, areal, sides);
    auto all = readings(wavevector, areal, sides);
    for (auto& reading : readings(frequency, areal, sides)) all.push_back(std::move(reading));
    return all;
}

std::string as_option(const SpectrumConvention& convention, const SpectrumUnits& stated) {
    const auto with = [](std::string words, const std::string& unit) {
        return unit.empty() ? words : words + " " + unit;
    };
    const bool areal = convention.areal();
    const char* sides = areal || convention.kind == DensityKind::radial ? "" : convention.one_sided ? "one-sided " : "";
    return with(convention.quantity, stated.wavevector) + ", " +
           with(sides + (convention.density.empty() ? "C1D" : convention.density), stated.density);
}

std::string normalisation(const SpectrumConvention& convention) {
    const bool of_frequency = convention.quantity == frequency;
    switch (convention.kind) {
        case DensityKind::per_cycle:
            if (of_frequency) return convention.one_sided ? "h_rms² = ∫ C df over f > 0" : "h_rms² = ∫ C df over ±f";
            return convention.one_sided ? "h_rms² = (1/2π) ∫ C dq over q > 0" : "h_rms² = (1/2π) ∫ C1D dq over ±q";
        case DensityKind::per_wavevector:
            return convention.one_sided ? "h_rms² = ∫ W dk over k > 0" : "h_rms² = ∫ W1 dk over ±k";
        case DensityKind::radial: return "h_rms² = ∫ Wr dk over k > 0";
        case DensityKind::areal: return "h_rms² = (1/2π) ∫ q C_iso dq";
        case DensityKind::areal_per_wavevector: return "h_rms² = 2π ∫ k W2 dk";
    }
    throw InternalError("a density without a normalisation");
}

}  // namespace setae::tables
