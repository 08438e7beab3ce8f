// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/scan_kernel.hpp"

#include <cmath>
#include <complex>
#include <map>
#include <memory>
#include <mutex>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/fast_length.hpp"
#include "setae/fourier/map_transform.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/numerics/dense.hpp"
#include "setae/platform/processes.hpp"
#include "setae/spectra/window.hpp"
#include "setae/spectral_fit/hat_node.hpp"

namespace setae::spectral_fit {
namespace {

using fourier::Buffer;
using fourier::Complex;

void require_shape(const ScanShape& shape) {
    if (shape.points < 8) throw InvalidArgument(fmt::format("a scan of {} points; expected at least 8", shape.points));
    constexpr int highest_degree = 12;
    if (shape.trend_degree < 0 || shape.trend_degree > highest_degree)
        throw InvalidArgument(fmt::format("trend of degree {}; expected 0 to {}", shape.trend_degree, highest_degree));
}

/// Orthonormal basis of polynomials on n points, one per column.
Eigen::MatrixXd trend_basis(const ScanShape& shape) {
    Eigen::MatrixXd powers(shape.points, shape.trend_degree + 1);
    const Array1D x = Array1D::LinSpaced(shape.points, -1.0, 1.0);
    for (Index d = 0; d <= shape.trend_degree; ++d) powers.col(d) = x.pow(static_cast<double>(d)).matrix();
    return numerics::orthonormal(powers);
}

/// Common data of all nodes of one shape.
class Workshop {
public:
    explicit Workshop(const ScanShape& shape)
        : shape_(shape),
          bins_(shape.points / 2),
          window_(spectra::window_values(spectra::Window::hann, shape.points)),
          basis_(trend_basis(shape)),
          line_(shape.points),
          padded_(fourier::fast_length(2 * shape.points)),
          wide_(padded_),
          wide_back_(padded_, fourier::ComplexTransform::Sign::plus) {
        window_covariance_ = correlation_of_window();
        for (Index l = 0; l < basis_.cols(); ++l) {
            trend_spectra_.push_back(spectrum(window_ * basis_.col(l).array()));
            padded_trends_.push_back(padded_spectrum(basis_.col(l).array()));
        }
    }

    [[nodiscard]] const ModeBins& bins() const { return bins_; }

    /// Mean over groups of modes of E|F(w ∘ (I − VVᵀ)h)|²/n for heights of autocovariance R(m), m = 0 … n − 1.
    [[nodiscard]] Array1D expected_periodogram(const Array1D& covariance) const {
        const Index n = shape_.points;
        Array1D folded(n);
        folded[0] = window_covariance_[0] * covariance[0];
        for (Index m = 1; m < n; ++m)
            folded[m] = window_covariance_[m] * covariance[m] + window_covariance_[n - m] * covariance[n - m];
        const auto plain = spectrum(folded);
        Array1D expected(n / 2);
        for (Index k = 1; k <= n / 2; ++k) expected[k - 1] = plain[static_cast<std::size_t>(k)].real();
        subtract_trends(expected, covariance);
        return bins_.means(expected) / static_cast<double>(n);
    }

private:
    void subtract_trends(Array1D& expected, const Array1D& covariance) const {
        const Index n = shape_.points, count = basis_.cols();
        const auto toeplitz = toeplitz_spectrum(covariance);
        Eigen::MatrixXd applied(n, count);
        for (Index l = 0; l < count; ++l)
            applied.col(l) = times_toeplitz(toeplitz, padded_trends_[static_cast<std::size_t>(l)]);
        const Eigen::MatrixXd between = numerics::transposed_product(basis_, applied);
        for (Index l = 0; l < count; ++l) {
            const auto moved = spectrum(window_ * applied.col(l).array());
            const auto& u = trend_spectra_[static_cast<std::size_t>(l)];
            for (Index k = 1; k <= n / 2; ++k) {
                const auto at = static_cast<std::size_t>(k);
                double value = -2.0 * (u[at].real() * moved[at].real() + u[at].imag() * moved[at].imag());
                for (Index m = 0; m < count; ++m) {
                    const Complex other = trend_spectra_[static_cast<std::size_t>(m)][at];
                    value += between(l, m) * (u[at].real() * other.real() + u[at].imag() * other.imag());
                }
                expected[k - 1] += value;
            }
        }
    }

    [[nodiscard]] Buffer<Complex> spectrum(const Array1D& values) const {
        Buffer<double> in(values.data(), values.data() + values.size());
        Buffer<Complex> out(static_cast<std::size_t>(line_.modes()));
        line_.forward(in.data(), out.data());
        return out;
    }

    [[nodiscard]] Buffer<Complex> padded_spectrum(const Array1D& values) const {
        Buffer<Complex> z(static_cast<std::size_t>(padded_), Complex{});
        for (Index i = 0; i < values.size(); ++i) z[static_cast<std::size_t>(i)] = values[i];
        wide_.apply(z.data());
        return z;
    }

    /// Eigenvalues of the circulant matrix that contains the Toeplitz matrix of the autocovariance: real, because it is
    /// even.
    [[nodiscard]] Array1D toeplitz_spectrum(const Array1D& covariance) const {
        Buffer<Complex> z(static_cast<std::size_t>(padded_), Complex{});
        for (Index m = 0; m < covariance.size(); ++m) {
            z[static_cast<std::size_t>(m)] = covariance[m];
            if (m > 0) z[static_cast<std::size_t>(padded_ - m)] = covariance[m];
        }
        wide_.apply(z.data());
        Array1D values(padded_);
        for (Index i = 0; i < padded_; ++i) values[i] = z[static_cast<std::size_t>(i)].real();
        return values;
    }

    [[nodiscard]] Eigen::VectorXd times_toeplitz(const Array1D& eigenvalues, const Buffer<Complex>& vector) const {
        Buffer<Complex> z(vector);
        for (Index i = 0; i < padded_; ++i) z[static_cast<std::size_t>(i)] *= eigenvalues[i];
        wide_back_.apply(z.data());
        Eigen::VectorXd result(shape_.points);
        for (Index i = 0; i < shape_.points; ++i)
            result[i] = z[static_cast<std::size_t>(i)].real() / static_cast<double>(padded_);
        return result;
    }

    /// a(m) = Σ_i w_i w_{i+m}, m = 0 … n − 1.
    [[nodiscard]] Array1D correlation_of_window() const {
        auto z = padded_spectrum(window_);
        for (auto& value : z) value = std::norm(value);
        wide_back_.apply(z.data());
        Array1D result(shape_.points);
        for (Index m = 0; m < shape_.points; ++m)
            result[m] = z[static_cast<std::size_t>(m)].real() / static_cast<double>(padded_);
        return result;
    }

    ScanShape shape_;
    ModeBins bins_;
    Array1D window_;
    Eigen::MatrixXd basis_;
    fourier::RealTransform line_;
    Index padded_;
    fourier::ComplexTransform wide_, wide_back_;
    Array1D window_covariance_;
    std::vector<Buffer<Complex>> trend_spectra_, padded_trends_;
};

double node_position(Index node) { return std::exp(node_spacing * static_cast<double>(node)); }

template <class Function>
Array1D covariance_of(Index points, double wavevector, Function autocovariance) {
    const double factor = wavevector * wavevector / (2.0 * pi);
    return Array1D::NullaryExpr(points,
                                [&](Index m) { return factor * autocovariance(wavevector * static_cast<double>(m)); });
}

/// Columns of one shape computed so far.
struct Store {
    explicit Store(const ScanShape& shape) : workshop(shape) { platform::free_in_every_child(mutex); }
    Workshop workshop;
    std::map<Index, Array1D> columns, flat_columns;
    std::mutex mutex;
};

Store& store_of(const ScanShape& shape) {
    static std::mutex mutex;
    static std::mutex& of_stores = platform::free_in_every_child(mutex);
    static std::map<ScanShape, std::unique_ptr<Store>> stores;
    const std::lock_guard lock(of_stores);
    auto& store = stores[shape];
    if (!store) store = std::make_unique<Store>(shape);
    return *store;
}

}  // namespace

Array1D scan_periodogram(const ArrayView2D& heights, double pixel_size, int trend_degree, parallel::Threads threads) {
    const ScanShape shape{heights.rows(), trend_degree};
    require_shape(shape);
    const Index n = shape.points, blocks = fourier::block_count(heights.cols());
    const Array1D window = spectra::window_values(spectra::Window::hann, n);
    const Eigen::MatrixXd basis = trend_basis(shape);
    Array2D power = Array2D::Zero(blocks, n / 2 + 1);
    const auto prepare = [&](Index j, double* values) {
        Eigen::Map<Eigen::VectorXd> line(values, n);
        if (!std::isfinite(line.sum()))
            throw UndefinedDataError(
                fmt::format("line {} along x has undefined heights; fill them or cut them off first", j));
        line -= basis * (basis.transpose() * line).eval();
        line.array() *= window;
    };
    const auto consume = [&](const fourier::SpectrumBlock& block) {
        for (Index m = 0; m < block.lines; ++m)
            for (Index k = 0; k <= n / 2; ++k) power(block.index, k) += std::norm(block.line(m)[k]);
    };
    fourier::transform_lines(heights, prepare, consume, threads);
    Array1D sum = Array1D::Zero(n / 2);
    for (Index b = 0; b < blocks; ++b) sum += power.row(b).tail(n / 2).transpose();
    return ModeBins(n / 2).means(sum) * (pixel_size / static_cast<double>(n * heights.cols()));
}

ScanKernel scan_kernel(const ScanShape& shape, Index first_node, Index last_node, parallel::Threads threads) {
    require_shape(shape);
    if (last_node < first_node)
        throw InvalidArgument(fmt::format("nodes {} … {} of a kernel; expected at least one", first_node, last_node));
    Store& store = store_of(shape);
    const std::lock_guard lock(store.mutex);
    std::vector<Index> missing;
    for (Index j = first_node; j <= last_node; ++j)
        if (!store.columns.contains(j)) missing.push_back(j);
    std::vector<Array1D> made(missing.size());
    parallel::for_each_index(missing.size(), threads, [&](std::size_t i) {
        made[i] = store.workshop.expected_periodogram(
            covariance_of(shape.points, node_position(missing[i]), hat_node::autocovariance));
    });
    for (std::size_t i = 0; i < missing.size(); ++i) store.columns.emplace(missing[i], std::move(made[i]));
    if (!store.flat_columns.contains(first_node)) {
        const auto below = [](double z) {
            return hat_node::autocovariance_of_disc(z) - hat_node::autocovariance_of_lower_half(z);
        };
        store.flat_columns.emplace(first_node, store.workshop.expected_periodogram(
                                                   covariance_of(shape.points, node_position(first_node), below)));
    }
    ScanKernel kernel{first_node,
                      Array2D(store.workshop.bins().size(), last_node - first_node + 1),
                      store.flat_columns.at(first_node),
                      {}};
    for (Index j = first_node; j <= last_node; ++j) kernel.response.col(j - first_node) = store.columns.at(j);
    Array1D white = Array1D::Zero(shape.points);
    white[0] = 1.0;
    kernel.noise_response = store.workshop.expected_periodogram(white);
    return kernel;
}

}  // namespace setae::spectral_fit
