// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include "setae/parallel/slab.hpp"

namespace setae::parallel {

/// The processes of a communicator, which outlives this object. MPI must be initialised; with threads, at least with
/// MPI_THREAD_FUNNELED.
class MpiRanks final : public Ranks {
public:
    explicit MpiRanks(MPI_Comm communicator);

    [[nodiscard]] int count() const override { return count_; }
    [[nodiscard]] int own() const override { return own_; }
    /// @throws InternalError for more than 2³¹ numbers.
    void share(double* all, std::span<const Index> begins) const override;
    /// @throws InternalError for more than 2³⁷ bytes per process.
    void exchange(const void* send, std::span<const Index> send_begins, void* receive,
                  std::span<const Index> receive_begins) const override;

private:
    MPI_Comm communicator_;
    int count_ = 1, own_ = 0;
};

}  // namespace setae::parallel
