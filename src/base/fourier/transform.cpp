// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/transform.hpp"

#include <limits>
#include <mutex>

#include <fftw3.h>
#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/platform/processes.hpp"

namespace setae::fourier {
namespace fftw {

/// FFTW's planner is not thread-safe; its executors are.
inline std::mutex& planner_mutex() {
    static std::mutex mutex;
    static std::mutex& planner = platform::free_in_every_child(mutex);
    return planner;
}

/// FFTW's functions for one kind of number.
template <class Real>
struct Fftw;
template <>
struct Fftw<double> {
    using Plan = fftw_plan;
    static constexpr auto plan_real = fftw_plan_dft_r2c_1d;
    static constexpr auto plan_inverse_real = fftw_plan_dft_c2r_1d;
    static constexpr auto plan_complex = fftw_plan_dft_1d;
    static constexpr auto execute_real = fftw_execute_dft_r2c;
    static constexpr auto execute_inverse_real = fftw_execute_dft_c2r;
    static constexpr auto execute_complex = fftw_execute_dft;
    static constexpr auto destroy = fftw_destroy_plan;
    static fftw_complex* of(Complex* values) { return reinterpret_cast<fftw_complex*>(values); }
};
template <>
struct Fftw<float> {
    using Plan = fftwf_plan;
    static constexpr auto plan_real = fftwf_plan_dft_r2c_1d;
    static constexpr auto plan_inverse_real = fftwf_plan_dft_c2r_1d;
    static constexpr auto plan_complex = fftwf_plan_dft_1d;
    static constexpr auto execute_real = fftwf_execute_dft_r2c;
    static constexpr auto execute_inverse_real = fftwf_execute_dft_c2r;
    static constexpr auto execute_complex = fftwf_execute_dft;
    static constexpr auto destroy = fftwf_destroy_plan;
    static fftwf_complex* of(ComplexOf<float>* values) { return reinterpret_cast<fftwf_complex*>(values); }
};

template <class Real>
struct PlanHandle {
    explicit PlanHandle(typename Fftw<Real>::Plan plan) : handle(plan) {}
    PlanHandle(const PlanHandle&) = delete;
    PlanHandle& operator=(const PlanHandle&) = delete;
    ~PlanHandle() {
        const std::lock_guard lock(planner_mutex());
        Fftw<Real>::destroy(handle);
    }
    typename Fftw<Real>::Plan handle;
};

}  // namespace fftw

using fftw::Fftw;
using fftw::PlanHandle;
using fftw::planner_mutex;

namespace {

/// Aligned memory for the planner, which with FFTW_ESTIMATE uses only addresses: never touched, so it costs nothing.
template <class T>
class Room {
public:
    explicit Room(Index n) : size_(static_cast<std::size_t>(n)), memory_(CacheLineAllocator<T>{}.allocate(size_)) {}
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;
    ~Room() { CacheLineAllocator<T>{}.deallocate(memory_, size_); }
    [[nodiscard]] T* data() const { return memory_; }

private:
    std::size_t size_;
    T* memory_;
};

/// FFTW counts points in int.
void require_points(Index n) {
    constexpr Index most = std::numeric_limits<int>::max();
    if (n < 1 || n > most)
        throw InvalidArgument(fmt::format("a transform of {} points; expected at least 1 and at most {}", n, most));
}

template <class Plan>
Plan checked(Plan plan, Index n) {
    if (plan == nullptr) throw InternalError(fmt::format("no plan of a transform exists for {} points", n));
    return plan;
}

template <class Real>
auto plan_real(Index n) {
    using F = Fftw<Real>;
    const Room<Real> in(n);
    const Room<ComplexOf<Real>> out(n / 2 + 1);
    const std::lock_guard lock(planner_mutex());
    return checked(F::plan_real(static_cast<int>(n), in.data(), F::of(out.data()), FFTW_ESTIMATE | FFTW_PRESERVE_INPUT),
                   n);
}

template <class Real>
auto plan_inverse_real(Index n) {
    using F = Fftw<Real>;
    const Room<ComplexOf<Real>> in(n / 2 + 1);
    const Room<Real> out(n);
    const std::lock_guard lock(planner_mutex());
    return checked(
        F::plan_inverse_real(static_cast<int>(n), F::of(in.data()), out.data(), FFTW_ESTIMATE | FFTW_DESTROY_INPUT), n);
}

template <class Real>
auto plan_complex(Index n, TransformSign sign) {
    using F = Fftw<Real>;
    const Room<ComplexOf<Real>> values(n);
    const int direction = sign == TransformSign::minus ? FFTW_FORWARD : FFTW_BACKWARD;
    const std::lock_guard lock(planner_mutex());
    return checked(
        F::plan_complex(static_cast<int>(n), F::of(values.data()), F::of(values.data()), direction, FFTW_ESTIMATE), n);
}

fftw_plan plan_even(Index n) {
    const Room<double> values(n);
    const std::lock_guard lock(planner_mutex());
    return checked(fftw_plan_r2r_1d(static_cast<int>(n), values.data(), values.data(), FFTW_REDFT00,
                                    FFTW_ESTIMATE | FFTW_UNALIGNED),
                   n);
}

}  // namespace

template <class Real>
struct RealTransformOf<Real>::Plan : PlanHandle<Real> {
    using PlanHandle<Real>::PlanHandle;
};

template <class Real>
RealTransformOf<Real>::RealTransformOf(Index n)
    : points_((require_points(n), n)), plan_(std::make_unique<Plan>(plan_real<Real>(n))) {}
template <class Real>
RealTransformOf<Real>::~RealTransformOf() = default;
template <class Real>
RealTransformOf<Real>::RealTransformOf(RealTransformOf&&) noexcept = default;
template <class Real>
RealTransformOf<Real>& RealTransformOf<Real>::operator=(RealTransformOf&&) noexcept = default;

template <class Real>
void RealTransformOf<Real>::forward(const Real* in, ComplexOf<Real>* out) const {
    // FFTW_PRESERVE_INPUT leaves the input unchanged
    Fftw<Real>::execute_real(plan_->handle, const_cast<Real*>(in), Fftw<Real>::of(out));
}

template class RealTransformOf<double>;
template class RealTransformOf<float>;

template <class Real>
struct InverseRealTransformOf<Real>::Plan : PlanHandle<Real> {
    using PlanHandle<Real>::PlanHandle;
};

template <class Real>
InverseRealTransformOf<Real>::InverseRealTransformOf(Index n)
    : points_((require_points(n), n)), plan_(std::make_unique<Plan>(plan_inverse_real<Real>(n))) {}
template <class Real>
InverseRealTransformOf<Real>::~InverseRealTransformOf() = default;
template <class Real>
InverseRealTransformOf<Real>::InverseRealTransformOf(InverseRealTransformOf&&) noexcept = default;
template <class Real>
InverseRealTransformOf<Real>& InverseRealTransformOf<Real>::operator=(InverseRealTransformOf&&) noexcept = default;

template <class Real>
void InverseRealTransformOf<Real>::apply(ComplexOf<Real>* in, Real* out) const {
    Fftw<Real>::execute_inverse_real(plan_->handle, Fftw<Real>::of(in), out);
}

template class InverseRealTransformOf<double>;
template class InverseRealTransformOf<float>;

template <class Real>
struct ComplexTransformOf<Real>::Plan : PlanHandle<Real> {
    using PlanHandle<Real>::PlanHandle;
};

template <class Real>
ComplexTransformOf<Real>::ComplexTransformOf(Index n, Sign sign)
    : points_((require_points(n), n)), plan_(std::make_unique<Plan>(plan_complex<Real>(n, sign))) {}
template <class Real>
ComplexTransformOf<Real>::~ComplexTransformOf() = default;
template <class Real>
ComplexTransformOf<Real>::ComplexTransformOf(ComplexTransformOf&&) noexcept = default;
template <class Real>
ComplexTransformOf<Real>& ComplexTransformOf<Real>::operator=(ComplexTransformOf&&) noexcept = default;

template <class Real>
void ComplexTransformOf<Real>::apply(ComplexOf<Real>* values) const {
    Fftw<Real>::execute_complex(plan_->handle, Fftw<Real>::of(values), Fftw<Real>::of(values));
}

template class ComplexTransformOf<double>;
template class ComplexTransformOf<float>;

struct EvenTransform::Plan : PlanHandle<double> {
    using PlanHandle::PlanHandle;
};

EvenTransform::EvenTransform(Index points) : points_(points) {
    require_points(points);
    if (points < 2) throw InvalidArgument("the even transform of one point; expected at least 2");
    plan_ = std::make_unique<Plan>(plan_even(points));
}
EvenTransform::~EvenTransform() = default;
EvenTransform::EvenTransform(EvenTransform&&) noexcept = default;
EvenTransform& EvenTransform::operator=(EvenTransform&&) noexcept = default;

void EvenTransform::apply(double* values) const { fftw_execute_r2r(plan_->handle, values, values); }

}  // namespace setae::fourier
