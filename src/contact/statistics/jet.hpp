// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace setae::statistics {

/// A number with its first and second derivatives by up to `most` variables, carried through + − · / ln.
struct Jet {
    static constexpr std::size_t most = 5;
    static constexpr std::size_t at(std::size_t i, std::size_t j) {
        return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
    }

    double value = 0.0;
    std::array<double, most> first{};
    std::array<double, most*(most + 1) / 2> second{};  ///< second derivative by variables i and j at at(i, j)

    Jet& operator+=(const Jet& other) {
        value += other.value;
        for (std::size_t i = 0; i < most; ++i) first[i] += other.first[i];
        for (std::size_t i = 0; i < second.size(); ++i) second[i] += other.second[i];
        return *this;
    }
};

inline Jet operator+(Jet a, const Jet& b) { return a += b; }

inline Jet operator*(double factor, Jet a) {
    a.value *= factor;
    for (auto& d : a.first) d *= factor;
    for (auto& d : a.second) d *= factor;
    return a;
}

inline Jet operator*(const Jet& a, const Jet& b) {
    Jet product{.value = a.value * b.value};
    for (std::size_t i = 0; i < Jet::most; ++i) {
        product.first[i] = a.value * b.first[i] + b.value * a.first[i];
        for (std::size_t j = 0; j <= i; ++j) {
            const auto ij = Jet::at(i, j);
            product.second[ij] =
                a.value * b.second[ij] + b.value * a.second[ij] + a.first[i] * b.first[j] + a.first[j] * b.first[i];
        }
    }
    return product;
}

/// f(a) from f and its two derivatives at a.value.
inline Jet chained(const Jet& a, double f, double slope, double curvature) {
    Jet result{.value = f};
    for (std::size_t i = 0; i < Jet::most; ++i) {
        result.first[i] = slope * a.first[i];
        for (std::size_t j = 0; j <= i; ++j)
            result.second[Jet::at(i, j)] = slope * a.second[Jet::at(i, j)] + curvature * a.first[i] * a.first[j];
    }
    return result;
}

inline Jet reciprocal(const Jet& a) {
    const double r = 1.0 / a.value;
    return chained(a, r, -r * r, 2.0 * r * r * r);
}

inline Jet log(const Jet& a) {
    const double r = 1.0 / a.value;
    return chained(a, std::log(a.value), r, -r * r);
}

/// exp(x) of the variable number `place`.
inline Jet exponential_of_variable(double x, std::size_t place) {
    Jet result{.value = std::exp(x)};
    result.first[place] = result.value;
    result.second[Jet::at(place, place)] = result.value;
    return result;
}

}  // namespace setae::statistics
