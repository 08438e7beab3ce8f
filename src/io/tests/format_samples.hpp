// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/io/channel.hpp"

/// Files of every format, made byte by byte, and what they hold. Each format has at least one map that is not square and whose
/// corners differ, so that no axis is taken for another. Tests, fuzzing and timings take their files from here.
namespace setae::io::tests {

struct FormatSample {
    std::string format;   ///< identifier in formats()
    std::string name;     ///< tells samples of a format apart: "int16, big-endian"
    std::string content;  ///< the file's bytes
    ReadOptions options = {};
    std::size_t channel = 0;   ///< the one described here
    std::vector<Index> shape;  ///< as ChannelInfo
    std::vector<double> size;  ///< [m], as ChannelInfo
    Array2D heights;           ///< [m], h(x, y), NaN undefined; a line has one column
    double tolerance = 1e-12;  ///< of heights, relative to the largest; of what the file's numbers can hold
    bool may_lose_its_end = false;  ///< nothing in the format tells how long a file is: cut, it is a shorter one
};

/// The samples of all formats, in the order of formats().
[[nodiscard]] std::vector<FormatSample> format_samples();

/// Heights that no turn or mirroring leaves as they are: h(i, j) = unit (1 + 3 i + 100 j + ((7 i + 13 j) mod 11)).
[[nodiscard]] Array2D lopsided_heights(Index nx, Index ny, double unit);

// one function a format, in formats/<name>_samples.cpp
[[nodiscard]] std::vector<FormatSample> netcdf_samples();
[[nodiscard]] std::vector<FormatSample> npy_samples();
[[nodiscard]] std::vector<FormatSample> npz_samples();
[[nodiscard]] std::vector<FormatSample> mat_samples();
[[nodiscard]] std::vector<FormatSample> hdf5_samples();
[[nodiscard]] std::vector<FormatSample> datx_samples();
[[nodiscard]] std::vector<FormatSample> jpk_hdf5_samples();
[[nodiscard]] std::vector<FormatSample> nanoscope_samples();

}  // namespace setae::io::tests
