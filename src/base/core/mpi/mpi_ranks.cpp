// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/parallel/mpi_ranks.hpp"

#include <limits>
#include <vector>

#include "setae/core/errors.hpp"

namespace setae::parallel {
namespace {

constexpr Index line = 64;  ///< bytes that are sent together

/// MPI counts in int.
struct Pieces {
    std::vector<int> counts, begins;
};

Pieces pieces(std::span<const Index> begins, Index unit) {
    if (begins.back() / unit > std::numeric_limits<int>::max())
        throw InternalError("the map has more numbers than MPI can count; distribute it over more processes");
    Pieces result;
    for (std::size_t rank = 0; rank + 1 < begins.size(); ++rank) {
        result.begins.push_back(static_cast<int>(begins[rank] / unit));
        result.counts.push_back(static_cast<int>((begins[rank + 1] - begins[rank]) / unit));
    }
    return result;
}

/// MPI type of a line of memory.
class LineType {
public:
    LineType() {
        MPI_Type_contiguous(static_cast<int>(line), MPI_BYTE, &type_);
        MPI_Type_commit(&type_);
    }
    ~LineType() { MPI_Type_free(&type_); }
    LineType(const LineType&) = delete;
    LineType& operator=(const LineType&) = delete;
    [[nodiscard]] MPI_Datatype get() const { return type_; }

private:
    MPI_Datatype type_{};
};

}  // namespace

MpiRanks::MpiRanks(MPI_Comm communicator) : communicator_(communicator) {
    MPI_Comm_size(communicator_, &count_);
    MPI_Comm_rank(communicator_, &own_);
}

void MpiRanks::share(double* all, std::span<const Index> begins) const {
    const auto [counts, places] = pieces(begins, 1);
    MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, all, counts.data(), places.data(), MPI_DOUBLE, communicator_);
}

void MpiRanks::exchange(const void* send, std::span<const Index> send_begins, void* receive,
                        std::span<const Index> receive_begins) const {
    const auto [sent, sent_from] = pieces(send_begins, line);
    const auto [received, received_at] = pieces(receive_begins, line);
    const LineType type;
    MPI_Alltoallv(send, sent.data(), sent_from.data(), type.get(), receive, received.data(), received_at.data(),
                  type.get(), communicator_);
}

}  // namespace setae::parallel
