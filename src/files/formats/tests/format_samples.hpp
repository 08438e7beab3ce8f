// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/formats/channel.hpp"

/// Files of every format, built byte by byte, and their content. Each format has at least one map that is not square
/// and whose corners differ, so exchanged axes are detected. Tests, fuzzing and timings use these files.
namespace setae::formats::tests {

struct FormatSample {
    std::string format;   ///< identifier in formats()
    std::string name;     ///< distinguishes samples of a format: "int16, big-endian"
    std::string content;  ///< the file's bytes
    ReadOptions options = {};
    std::size_t channel = 0;         ///< the one described here
    std::vector<Index> shape;        ///< see ChannelInfo
    std::vector<double> size;        ///< [m], see ChannelInfo
    Array2D heights;                 ///< [m], h(x, y), NaN undefined; a line has one column
    double tolerance = 1e-12;        ///< of heights, relative to the largest; limited by the numbers of the file
    std::string member_format = {};  ///< of the channel, if it is that of a file inside this one
    bool may_lose_its_end = false;   ///< the format does not contain the length of the file: a truncated file is a
                                     ///< shorter one
};

/// Name in tests.
inline void PrintTo(const FormatSample& sample, std::ostream* out) { *out << sample.format << ", " << sample.name; }

/// The samples of all formats, in the order of formats().
[[nodiscard]] std::vector<FormatSample> format_samples();

/// Heights that change with every rotation and reflection: h(i, j) = unit (1 + 3 i + 100 j + ((7 i + 13 j) mod 11)).
[[nodiscard]] Array2D lopsided_heights(Index nx, Index ny, double unit);

// one function per format, in formats/<name>_samples.cpp
[[nodiscard]] std::vector<FormatSample> container_samples();
[[nodiscard]] std::vector<FormatSample> x3p_samples();
[[nodiscard]] std::vector<FormatSample> sdf_samples();
[[nodiscard]] std::vector<FormatSample> gwy_samples();
[[nodiscard]] std::vector<FormatSample> gsf_samples();
[[nodiscard]] std::vector<FormatSample> netcdf_samples();
[[nodiscard]] std::vector<FormatSample> npy_samples();
[[nodiscard]] std::vector<FormatSample> npz_samples();
[[nodiscard]] std::vector<FormatSample> mat_samples();
[[nodiscard]] std::vector<FormatSample> hdf5_samples();
[[nodiscard]] std::vector<FormatSample> datx_samples();
[[nodiscard]] std::vector<FormatSample> jpk_hdf5_samples();
[[nodiscard]] std::vector<FormatSample> topostats_samples();
[[nodiscard]] std::vector<FormatSample> nanoscope_samples();
[[nodiscard]] std::vector<FormatSample> ibw_samples();
[[nodiscard]] std::vector<FormatSample> jpk_samples();
[[nodiscard]] std::vector<FormatSample> jpk_qi_samples();
[[nodiscard]] std::vector<FormatSample> park_samples();
[[nodiscard]] std::vector<FormatSample> mi_samples();
[[nodiscard]] std::vector<FormatSample> nanosurf_samples();
[[nodiscard]] std::vector<FormatSample> wsxm_samples();
[[nodiscard]] std::vector<FormatSample> mdt_samples();
[[nodiscard]] std::vector<FormatSample> nmm_samples();
[[nodiscard]] std::vector<FormatSample> nanonis_samples();
[[nodiscard]] std::vector<FormatSample> opd_samples();
[[nodiscard]] std::vector<FormatSample> opdx_samples();
[[nodiscard]] std::vector<FormatSample> metropro_samples();
[[nodiscard]] std::vector<FormatSample> bcr_samples();
[[nodiscard]] std::vector<FormatSample> nms_samples();
[[nodiscard]] std::vector<FormatSample> frt_samples();
[[nodiscard]] std::vector<FormatSample> tmd_samples();
[[nodiscard]] std::vector<FormatSample> zmg_samples();
[[nodiscard]] std::vector<FormatSample> os3d_samples();
[[nodiscard]] std::vector<FormatSample> qep_samples();
[[nodiscard]] std::vector<FormatSample> plu_samples();
[[nodiscard]] std::vector<FormatSample> plux_samples();
[[nodiscard]] std::vector<FormatSample> al3d_samples();
[[nodiscard]] std::vector<FormatSample> sur_samples();
[[nodiscard]] std::vector<FormatSample> mnt_samples();
[[nodiscard]] std::vector<FormatSample> vk_samples();
[[nodiscard]] std::vector<FormatSample> zon_samples();
[[nodiscard]] std::vector<FormatSample> zag_samples();
[[nodiscard]] std::vector<FormatSample> lext_samples();
[[nodiscard]] std::vector<FormatSample> oir_samples();
[[nodiscard]] std::vector<FormatSample> poir_samples();
[[nodiscard]] std::vector<FormatSample> height_tiff_samples();
[[nodiscard]] std::vector<FormatSample> mitutoyo_samples();
[[nodiscard]] std::vector<FormatSample> workbook_samples();
[[nodiscard]] std::vector<FormatSample> dektak_csv_samples();
[[nodiscard]] std::vector<FormatSample> hfm_samples();
[[nodiscard]] std::vector<FormatSample> dabam_samples();
[[nodiscard]] std::vector<FormatSample> matrix_text_samples();
[[nodiscard]] std::vector<FormatSample> xyz_samples();
[[nodiscard]] std::vector<FormatSample> xy_samples();

}  // namespace setae::formats::tests
