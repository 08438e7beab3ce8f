// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/units.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"

namespace setae {

Dimension operator*(const Dimension& a, const Dimension& b) {
    Dimension product;
    for (std::size_t i = 0; i < a.exponents.size(); ++i) product.exponents[i] = a.exponents[i] + b.exponents[i];
    return product;
}

Dimension operator/(const Dimension& a, const Dimension& b) {
    Dimension quotient;
    for (std::size_t i = 0; i < a.exponents.size(); ++i) quotient.exponents[i] = a.exponents[i] - b.exponents[i];
    return quotient;
}

namespace {

constexpr Dimension mass{{0, 1, 0, 0, 0, 0}};
constexpr Dimension amount{{0, 0, 0, 0, 1, 0}};
constexpr Dimension current{{0, 0, 0, 0, 0, 1}};
constexpr Dimension voltage{{2, 1, -3, 0, 0, -1}};
constexpr Dimension capacitance{{-2, -1, 4, 0, 0, 2}};
constexpr Dimension frequency{{0, 0, -1, 0, 0, 0}};

struct Symbol {
    std::string_view name;
    double factor;
    Dimension dimension;
    bool prefixable;
};

constexpr double inch = 0.0254, gram_force = 9.80665e-3, pound_force = 4.4482216152605;  // exact by definition
constexpr double ounce_force = pound_force / 16.0, pound = 0.45359237;

constexpr std::array<Symbol, 42> symbols{{
    {"m", 1.0, dimension::length, true},
    {"g", 1e-3, mass, true},
    {"s", 1.0, dimension::time, true},
    {"K", 1.0, dimension::temperature, true},
    {"mol", 1.0, amount, true},
    {"A", 1.0, current, true},
    {"N", 1.0, dimension::force, true},
    {"J", 1.0, dimension::energy, true},
    {"Pa", 1.0, dimension::pressure, true},
    {"V", 1.0, voltage, true},
    {"F", 1.0, capacitance, true},
    {"f", 1.0, capacitance, true},
    {"Hz", 1.0, frequency, true},
    {"gf", gram_force, dimension::force, true},
    {"kp", 1e3 * gram_force, dimension::force, false},
    {"lbf", pound_force, dimension::force, false},
    {"ozf", ounce_force, dimension::force, false},
    {"dyn", 1e-5, dimension::force, true},
    {"lb", pound, mass, false},
    {"oz", pound / 16.0, mass, false},
    {"in", inch, dimension::length, false},
    {"uin", 1e-6 * inch, dimension::length, false},
    {"\u00b5in", 1e-6 * inch, dimension::length, false},
    {"\u03bcin", 1e-6 * inch, dimension::length, false},
    {"mil", 1e-3 * inch, dimension::length, false},
    {"thou", 1e-3 * inch, dimension::length, false},
    {"Å", 1e-10, dimension::length, false},
    {"Å", 1e-10, dimension::length, false},
    {"sec", 1.0, dimension::time, false},
    {"msec", 1e-3, dimension::time, false},
    {"min", 60.0, dimension::time, false},
    {"h", 3600.0, dimension::time, false},
    {"hr", 3600.0, dimension::time, false},
    {"%", 1e-2, dimension::none, false},
    {"1", 1.0, dimension::none, false},
    {"rad", 1.0, dimension::none, false},
    {"cycles", 1.0, dimension::none, false},
    {"cycle", 1.0, dimension::none, false},
    {"cyc", 1.0, dimension::none, false},
    {"lp", 1.0, dimension::none, false},  // line pairs, as optics counts periods
    {"deg", pi / 180.0, dimension::none, false},
    {"-", 1.0, dimension::none, false},
}};

/// Units as words, without the plural 's'.
constexpr std::array<Symbol, 19> words{{
    {"meter", 1.0, dimension::length, true},
    {"metre", 1.0, dimension::length, true},
    {"newton", 1.0, dimension::force, true},
    {"second", 1.0, dimension::time, true},
    {"sekunde", 1.0, dimension::time, true},
    {"sekunden", 1.0, dimension::time, true},
    {"gram", 1e-3, mass, true},
    {"gramm", 1e-3, mass, true},
    {"angstrom", 1e-10, dimension::length, false},
    {"micron", 1e-6, dimension::length, false},
    {"inch", inch, dimension::length, true},
    {"inche", inch, dimension::length, true},
    {"mil", 1e-3 * inch, dimension::length, false},
    {"pound", pound, mass, false},
    {"lb", pound, mass, false},
    {"ounce", pound / 16.0, mass, false},
    {"dyne", 1e-5, dimension::force, false},
    {"minute", 60.0, dimension::time, false},
    {"hour", 3600.0, dimension::time, false},
}};

struct Prefix {
    std::string_view name;
    double factor;
};

constexpr std::array<Prefix, 15> prefixes{{{"T", 1e12},
                                           {"G", 1e9},
                                           {"M", 1e6},
                                           {"k", 1e3},
                                           {"h", 1e2},
                                           {"d", 1e-1},
                                           {"c", 1e-2},
                                           {"m", 1e-3},
                                           {"u", 1e-6},
                                           {"\u00b5", 1e-6},
                                           {"\u03bc", 1e-6},
                                           {"~", 1e-6},
                                           {"n", 1e-9},
                                           {"p", 1e-12},
                                           {"f", 1e-15}}};

constexpr std::array<Prefix, 9> prefix_words{{{"kilo", 1e3},
                                              {"deci", 1e-1},
                                              {"centi", 1e-2},
                                              {"zenti", 1e-2},
                                              {"milli", 1e-3},
                                              {"micro", 1e-6},
                                              {"mikro", 1e-6},
                                              {"nano", 1e-9},
                                              {"pico", 1e-12}}};

/// A unit of `known`, with a prefix of `before` if the unit allows one.
std::optional<Unit> found(std::string_view name, std::span<const Symbol> known, std::span<const Prefix> before) {
    for (const auto& symbol : known)
        if (symbol.name == name) return Unit{symbol.factor, symbol.dimension};
    for (const auto& prefix : before) {
        if (!name.starts_with(prefix.name)) continue;
        const auto rest = name.substr(prefix.name.size());
        for (const auto& symbol : known)
            if (symbol.prefixable && symbol.name == rest) return Unit{prefix.factor * symbol.factor, symbol.dimension};
    }
    return std::nullopt;
}

std::optional<Unit> lookup(std::string_view name) {
    if (const auto unit = found(name, symbols, prefixes)) return unit;
    constexpr std::size_t shortest_word = 3;
    if (name.size() < shortest_word) return std::nullopt;
    std::string word(name);
    for (auto& c : word)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (word.ends_with('s')) word.pop_back();
    return found(word, words, prefix_words);
}

/// Superscripts to ASCII digits, product dots to '*': one grammar serves every spelling.
std::string plain(std::string_view text) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 14> replacements{{{"⁻", "-"},
                                                                                                 {"⁰", "0"},
                                                                                                 {"¹", "1"},
                                                                                                 {"²", "2"},
                                                                                                 {"³", "3"},
                                                                                                 {"⁴", "4"},
                                                                                                 {"⁵", "5"},
                                                                                                 {"⁶", "6"},
                                                                                                 {"⁷", "7"},
                                                                                                 {"⁸", "8"},
                                                                                                 {"⁹", "9"},
                                                                                                 {"·", "*"},
                                                                                                 {"⋅", "*"},
                                                                                                 {"−", "-"}}};
    std::string result(text);
    for (const auto& [from, to] : replacements)
        for (auto at = result.find(from); at != std::string::npos; at = result.find(from, at + to.size()))
            result.replace(at, from.size(), to);
    return result;
}

bool is_exponent_char(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '^'; }

/// One factor such as "m2", "m^-1", "mJ", "1".
Unit parse_factor(std::string_view factor, std::string_view whole) {
    if (auto unit = lookup(factor)) return *unit;
    auto split = factor.size();
    while (split > 0 && is_exponent_char(factor[split - 1])) --split;
    auto digits = factor.substr(split);
    if (digits.starts_with('^')) digits.remove_prefix(1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto exponent = spelled<int>(digits).value_or(99);
    const auto base = lookup(factor.substr(0, split));
    if (!base || std::abs(exponent) > 9)
        throw InvalidArgument(
            fmt::format("'{}' is not a known unit; write it like nm, um, mJ/m2, MPa, 1/m, m3", whole));
    Unit power;
    for (int i = 0; i < std::abs(exponent); ++i) {
        power.factor *= base->factor;
        power.dimension = power.dimension * base->dimension;
    }
    if (exponent < 0) return {1.0 / power.factor, dimension::none / power.dimension};
    return power;
}

bool is_separator(char c) { return c == '*' || c == '/' || c == ' ' || c == '.' || c == '(' || c == ')'; }

struct NumberAndRest {
    double number;
    std::string_view rest;
};

NumberAndRest leading_number(std::string_view text, std::string_view whole) {
    auto body = trimmed(text);
    if (body.starts_with('+')) body.remove_prefix(1);
    const auto number = leading<double>(body);
    if (!number)
        throw InvalidArgument(
            fmt::format("'{}' does not begin with a number; write number and unit, such as 37 mJ/m2", whole));
    return {*number, trimmed(body)};
}

/// A value of a dimension, with an example.
std::string value_of(const Dimension& dimension) {
    struct Named {
        Dimension dimension;
        std::string_view words;
    };
    static constexpr std::array<Named, 7> named{{
        {dimension::length, "a length with its unit, such as \"5 um\""},
        {dimension::pressure, "a pressure with its unit, such as \"2 MPa\""},
        {dimension::surface_energy, "an energy per area with its unit, such as \"40 mJ/m2\""},
        {dimension::force, "a force with its unit, such as \"1 mN\""},
        {dimension::energy, "an energy with its unit, such as \"1 nJ\""},
        {dimension::time, "a time with its unit, such as \"10 s\""},
        {dimension::wavevector, "a wavevector with its unit, such as \"10 1/um\""},
    }};
    for (const auto& [known, words] : named)
        if (known == dimension) return std::string(words);
    return "a value with a unit of " + si_unit(dimension);
}

double in_si(double number, std::string_view unit, const Dimension& expected, std::string_view whole) {
    if (unit.empty()) {
        if (expected == dimension::none || number == 0.0) return number;
        throw InvalidArgument(fmt::format("'{}' has no unit; expected {}", whole, value_of(expected)));
    }
    return number * unit_factor(unit, expected);
}

}  // namespace

Unit parse_unit(std::string_view text) {
    const auto source = plain(trimmed(text));
    if (source.empty()) throw InvalidArgument("empty unit; a dimensionless quantity has the unit '1'");
    Unit unit;
    bool divide = false;
    std::size_t at = 0;
    bool inside_denominator = false;
    while (at < source.size()) {
        if (is_separator(source[at])) {
            if (source[at] == '/') divide = true;
            if (source[at] == '(' && divide) inside_denominator = true;
            if (source[at] == ')') inside_denominator = divide = false;
            ++at;
            continue;
        }
        auto end = at;
        while (end < source.size() && !is_separator(source[end])) ++end;
        const auto factor = parse_factor(std::string_view(source).substr(at, end - at), text);
        if (divide) {
            unit.factor /= factor.factor;
            unit.dimension = unit.dimension / factor.dimension;
        } else {
            unit.factor *= factor.factor;
            unit.dimension = unit.dimension * factor.dimension;
        }
        divide = inside_denominator;
        at = end;
    }
    return unit;
}

double unit_factor(std::string_view text, const Dimension& expected) {
    if (expected == dimension::length && trimmed(text) == "A") return units::angstrom;
    const auto unit = parse_unit(text);
    if (unit.dimension != expected)
        throw InvalidArgument(
            fmt::format("unit '{}' is {}, expected one of {}", text, si_unit(unit.dimension), si_unit(expected)));
    return unit.factor;
}

namespace {

/// Powers of any quantity remain within the range of a double. The fourth power of the largest is 1e240.
constexpr double min_magnitude = 1e-60, greatest_magnitude = 1e60;

/// @throws InvalidArgument for a number outside the range of measurements.
void require_magnitude(double value, std::string_view given) {
    const double magnitude = std::abs(value);
    if (value == 0.0 || (magnitude >= min_magnitude && magnitude <= greatest_magnitude)) return;
    throw InvalidArgument(fmt::format("'{}', expected 0 or a magnitude from {:g} to {:g} in SI units", given,
                                      min_magnitude, greatest_magnitude));
}

}  // namespace

void require_within(const Domain& domain, double value, std::string_view given) {
    const bool inside =
        std::isfinite(value) && (domain.open ? value > domain.lower : value >= domain.lower) && value <= domain.upper;
    if (!inside) throw InvalidArgument(fmt::format("'{}', expected {}", given, domain.words));
    require_magnitude(value, given);
}

double parse_quantity(std::string_view text, const Expected& expected) {
    const auto [number, unit] = leading_number(text, text);
    const double value = in_si(number, unit, expected.dimension, text);
    require_within(expected.domain, value, text);
    return value;
}

namespace {

/// "37.0 ± 3.7 mJ/m2", split at the sign.
Estimate value_and_error(std::string_view of_value, std::string_view of_error, const Expected& expected,
                         std::string_view text) {
    const auto value = leading_number(of_value, text), error = leading_number(of_error, text);
    if (!(error.number >= 0.0 && std::isfinite(error.number)))
        throw InvalidArgument(fmt::format("'{}', expected an uncertainty >= 0", text));
    const Estimate estimate{in_si(value.number, value.rest.empty() ? error.rest : value.rest, expected.dimension, text),
                            in_si(error.number, error.rest, expected.dimension, text), "given"};
    require_magnitude(estimate.standard_error, text);
    require_within(expected.domain, estimate.value, text);
    if (expected.domain.open && expected.domain.lower == 0.0 && estimate.standard_error > estimate.value)
        throw InvalidArgument(
            fmt::format("'{}', the uncertainty is larger than the value, which must be above 0", text));
    return estimate;
}

/// "1.2 to 1.3 mm", split at the word: a uniform distribution.
Estimate value_between(std::string_view of_lower, std::string_view of_upper, const Expected& expected,
                       std::string_view text) {
    const auto lower = leading_number(of_lower, text), upper = leading_number(of_upper, text);
    const double from = in_si(lower.number, lower.rest.empty() ? upper.rest : lower.rest, expected.dimension, text),
                 to = in_si(upper.number, upper.rest, expected.dimension, text);
    if (!(from <= to)) throw InvalidArgument(fmt::format("'{}', expected the smaller value first", text));
    for (const double end : {from, to}) require_within(expected.domain, end, text);
    return {0.5 * (from + to), (to - from) / std::sqrt(12.0), "rectangular", Interval{from, to, 1.0}};
}

}  // namespace

Estimate parse_uncertain_quantity(std::string_view text, const Expected& expected) {
    static constexpr std::array<std::string_view, 3> separators{"±", "+-", "+/-"};
    for (const auto separator : separators)
        if (const auto at = text.find(separator); at != std::string_view::npos)
            return value_and_error(text.substr(0, at), text.substr(at + separator.size()), expected, text);
    static constexpr std::string_view to = " to ";
    if (const auto at = text.find(to); at != std::string_view::npos)
        return value_between(text.substr(0, at), text.substr(at + to.size()), expected, text);
    return {parse_quantity(text, expected), 0.0, "given"};
}

std::string si_unit(const Dimension& dimension) {
    struct Named {
        Dimension dimension;
        std::string_view name;
    };
    static constexpr std::array<Named, 12> named{{{dimension::none, "1"},
                                                  {dimension::force, "N"},
                                                  {dimension::pressure, "Pa"},
                                                  {dimension::energy, "J"},
                                                  {dimension::surface_energy, "J/m2"},
                                                  {voltage, "V"},
                                                  {capacitance, "F"},
                                                  {frequency, "1/s"},
                                                  {current, "A"},
                                                  {dimension::molar_mass, "kg/mol"},
                                                  {dimension::wavevector, "1/m"},
                                                  {dimension::temperature, "K"}}};
    for (const auto& [known, name] : named)
        if (known == dimension) return std::string(name);
    static constexpr std::array<std::string_view, 6> base{"m", "kg", "s", "K", "mol", "A"};
    std::string numerator, denominator;
    for (std::size_t i = 0; i < base.size(); ++i) {
        const int exponent = dimension.exponents[i];
        if (exponent == 0) continue;
        auto& side = exponent > 0 ? numerator : denominator;
        if (!side.empty()) side += ' ';
        side += base[i];
        if (std::abs(exponent) > 1) side += std::to_string(std::abs(exponent));
    }
    if (numerator.empty()) numerator = "1";
    if (denominator.empty()) return numerator;
    return numerator + (denominator.find(' ') == std::string::npos ? "/" + denominator : "/(" + denominator + ")");
}

namespace {

std::string with_digits(double value, int significant_digits) {
    const auto magnitude = value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (magnitude < -3 || magnitude >= 6) {
        return fmt::format("{:.{}f}×10{}", value / std::pow(10.0, magnitude), significant_digits - 1,
                           superscript(magnitude));
    }
    return fmt::format("{:.{}f}", value, std::max(0, significant_digits - 1 - magnitude));
}

struct Scale {
    double factor;
    std::string_view name;
};

/// Prefixed units for display; lengths exclude Å, the reciprocals follow the lengths.
std::vector<Scale> display_scales(std::string_view si) {
    if (si == "m") return {{1e-12, "pm"}, {1e-9, "nm"}, {1e-6, "µm"}, {1e-3, "mm"}, {1.0, "m"}};
    if (si == "1/m") return {{1.0, "m⁻¹"}, {1e3, "mm⁻¹"}, {1e6, "µm⁻¹"}, {1e9, "nm⁻¹"}};
    if (si == "J/m2") return {{1e-6, "µJ/m²"}, {1e-3, "mJ/m²"}, {1.0, "J/m²"}};
    if (si == "Pa") return {{1.0, "Pa"}, {1e3, "kPa"}, {1e6, "MPa"}, {1e9, "GPa"}};
    if (si == "N") return {{1e-9, "nN"}, {1e-6, "µN"}, {1e-3, "mN"}, {1.0, "N"}};
    if (si == "J") return {{1e-15, "fJ"}, {1e-12, "pJ"}, {1e-9, "nJ"}, {1e-6, "µJ"}, {1e-3, "mJ"}, {1.0, "J"}};
    if (si == "s") return {{1e-3, "ms"}, {1.0, "s"}};
    return {};
}

}  // namespace

std::string superscript(int number) {
    static constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(number))) text += digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

DisplayUnit display_unit(double value, std::string_view si_unit) {
    const auto scales = display_scales(si_unit);
    if (scales.empty()) return {1.0, std::string(si_unit)};
    const bool plain = value == 0.0 || !std::isfinite(value);
    auto chosen = scales.front();
    for (const auto& scale : scales)
        if (plain ? scale.factor == 1.0 : std::abs(value) >= scale.factor) chosen = scale;
    return {chosen.factor, std::string(chosen.name)};
}

std::string format_value(double value, std::string_view si_unit, int significant_digits) {
    if (std::isnan(value)) return "–";
    if (std::isinf(value)) return value > 0 ? "infinite" : "−infinite";
    const auto unit = display_unit(value, si_unit);
    const auto number = with_digits(value / unit.factor, significant_digits);
    return unit.name == "1" ? number : fmt::format("{} {}", number, unit.name);
}

}  // namespace setae
