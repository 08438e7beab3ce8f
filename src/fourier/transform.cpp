// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/transform.hpp"

#include <limits>
#include <mutex>

#include <fftw3.h>
#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"

namespace setae::fourier {
namespace {

/// FFTW's planner is not thread-safe; its executors are.
std::mutex& planner_mutex() {
    static std::mutex mutex;
    return mutex;
}

/// Aligned memory for the planner, which with FFTW_ESTIMATE looks at addresses only: never touched, so it costs
/// nothing.
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

fftw_complex* as_fftw(Complex* values) { return reinterpret_cast<fftw_complex*>(values); }

/// FFTW counts points in int.
void require_points(Index n) {
    constexpr Index most = std::numeric_limits<int>::max();
    if (n < 1 || n > most)
        throw InvalidArgument(fmt::format("a transform of {} points; expected at least 1 and at most {}", n, most));
}

template <class Planned>
fftw_plan checked(Planned plan, Index n) {
    if (plan == nullptr) throw InternalError(fmt::format("no transform plan for {} points", n));
    return plan;
}

struct PlanHandle {
    explicit PlanHandle(fftw_plan plan) : handle(plan) {}
    PlanHandle(const PlanHandle&) = delete;
    PlanHandle& operator=(const PlanHandle&) = delete;
    ~PlanHandle() {
        const std::lock_guard lock(planner_mutex());
        fftw_destroy_plan(handle);
    }
    fftw_plan handle;
};

fftw_plan plan_real(Index n) {
    const Room<double> in(n);
    const Room<Complex> out(n / 2 + 1);
    const std::lock_guard lock(planner_mutex());
    return checked(
        fftw_plan_dft_r2c_1d(static_cast<int>(n), in.data(), as_fftw(out.data()), FFTW_ESTIMATE | FFTW_PRESERVE_INPUT),
        n);
}

fftw_plan plan_inverse_real(Index n) {
    const Room<Complex> in(n / 2 + 1);
    const Room<double> out(n);
    const std::lock_guard lock(planner_mutex());
    return checked(
        fftw_plan_dft_c2r_1d(static_cast<int>(n), as_fftw(in.data()), out.data(), FFTW_ESTIMATE | FFTW_DESTROY_INPUT),
        n);
}

fftw_plan plan_complex(Index n, ComplexTransform::Sign sign) {
    const Room<Complex> values(n);
    const int direction = sign == ComplexTransform::Sign::minus ? FFTW_FORWARD : FFTW_BACKWARD;
    const std::lock_guard lock(planner_mutex());
    return checked(
        fftw_plan_dft_1d(static_cast<int>(n), as_fftw(values.data()), as_fftw(values.data()), direction, FFTW_ESTIMATE),
        n);
}

fftw_plan plan_even(Index n) {
    const Room<double> values(n);
    const std::lock_guard lock(planner_mutex());
    return checked(fftw_plan_r2r_1d(static_cast<int>(n), values.data(), values.data(), FFTW_REDFT00,
                                    FFTW_ESTIMATE | FFTW_UNALIGNED),
                   n);
}

}  // namespace

struct RealTransform::Plan : PlanHandle {
    using PlanHandle::PlanHandle;
};

RealTransform::RealTransform(Index n) : points_((require_points(n), n)), plan_(std::make_unique<Plan>(plan_real(n))) {}
RealTransform::~RealTransform() = default;
RealTransform::RealTransform(RealTransform&&) noexcept = default;
RealTransform& RealTransform::operator=(RealTransform&&) noexcept = default;

void RealTransform::forward(const double* in, Complex* out) const {
    // FFTW_PRESERVE_INPUT keeps the promise of const
    fftw_execute_dft_r2c(plan_->handle, const_cast<double*>(in), as_fftw(out));
}

struct InverseRealTransform::Plan : PlanHandle {
    using PlanHandle::PlanHandle;
};

InverseRealTransform::InverseRealTransform(Index n)
    : points_((require_points(n), n)), plan_(std::make_unique<Plan>(plan_inverse_real(n))) {}
InverseRealTransform::~InverseRealTransform() = default;
InverseRealTransform::InverseRealTransform(InverseRealTransform&&) noexcept = default;
InverseRealTransform& InverseRealTransform::operator=(InverseRealTransform&&) noexcept = default;

void InverseRealTransform::apply(Complex* in, double* out) const {
    fftw_execute_dft_c2r(plan_->handle, as_fftw(in), out);
}

struct ComplexTransform::Plan : PlanHandle {
    using PlanHandle::PlanHandle;
};

ComplexTransform::ComplexTransform(Index n, Sign sign)
    : points_((require_points(n), n)), plan_(std::make_unique<Plan>(plan_complex(n, sign))) {}
ComplexTransform::~ComplexTransform() = default;
ComplexTransform::ComplexTransform(ComplexTransform&&) noexcept = default;
ComplexTransform& ComplexTransform::operator=(ComplexTransform&&) noexcept = default;

void ComplexTransform::apply(Complex* values) const {
    fftw_execute_dft(plan_->handle, as_fftw(values), as_fftw(values));
}

struct EvenTransform::Plan : PlanHandle {
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
