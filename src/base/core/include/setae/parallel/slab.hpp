// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::parallel {

/// Processes that work on one problem, each with its own memory. All of them call the same members in the same order,
/// from one thread each.
class Ranks {
public:
    virtual ~Ranks() = default;
    [[nodiscard]] virtual int count() const = 0;
    [[nodiscard]] virtual int own() const = 0;
    /// Shares the numbers of all ranks. all: rank r owns the numbers from begins[r] to begins[r + 1] − 1; its own are
    /// already there.
    virtual void share(double* all, std::span<const Index> begins) const = 0;
    /// Sends to every rank r the bytes from send_begins[r] to send_begins[r + 1] − 1, and receives from rank r the
    /// bytes from receive_begins[r] to receive_begins[r + 1] − 1. Begins are multiples of 64.
    virtual void exchange(const void* send, std::span<const Index> send_begins, void* receive,
                          std::span<const Index> receive_begins) const = 0;
};

/// The rows 0 … n − 1 of a map that each process holds: a contiguous range, in order of ranks.
class Slab {
public:
    /// All rows in one process.
    explicit Slab(Index rows);
    /// begins: the first row of each rank, then n. ranks outlives the slab; nullptr: one process.
    Slab(const Ranks* ranks, std::vector<Index> begins);

    [[nodiscard]] int ranks() const { return static_cast<int>(begins_.size()) - 1; }
    [[nodiscard]] bool in_one_process() const { return ranks_ == nullptr; }
    [[nodiscard]] Index begin(int rank) const { return begins_[static_cast<std::size_t>(rank)]; }
    [[nodiscard]] Index rows(int rank) const { return begin(rank + 1) - begin(rank); }
    /// First row of this process.
    [[nodiscard]] Index first() const { return begin(own()); }
    [[nodiscard]] Index rows() const { return rows(own()); }
    /// Rows of all processes.
    [[nodiscard]] Index all() const { return begins_.back(); }

    /// Shares one number per row: each process gives those of its rows and receives the others.
    void share(double* all) const;
    /// Whether the condition is true in any process.
    [[nodiscard]] bool anywhere(bool here) const;
    /// Another division of rows, such as blocks of a spectrum, over the same processes.
    [[nodiscard]] Slab among_same(std::vector<Index> begins) const { return {ranks_, std::move(begins)}; }
    /// See Ranks::exchange. Not for one process.
    void exchange(const void* send, std::span<const Index> send_begins, void* receive,
                  std::span<const Index> receive_begins) const;

private:
    [[nodiscard]] int own() const { return ranks_ != nullptr ? ranks_->own() : 0; }

    const Ranks* ranks_ = nullptr;
    std::vector<Index> begins_;
};

/// n halved as long as it is even and above `coarsest`: the side of the coarsest of nested maps.
[[nodiscard]] Index coarsest_side_of(Index n, Index coarsest);

/// Rows of a map, divided as evenly as the coarser maps of the same problem allow: every coarser map has the halves of
/// the same rows in the same process, and in the coarsest map per process begins at a multiple of `step`.
/// ranks: nullptr or one process: all rows.
/// @throws InvalidArgument for more ranks than the coarsest map has steps.
[[nodiscard]] Slab nested_slab(Index rows, Index coarsest, Index step, const Ranks* ranks);

}  // namespace setae::parallel
