// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/formats/format.hpp"

/// One function per format, in formats/<name>.cpp: description and functions of the format. formats.cpp collects them
/// in the table.
namespace setae::formats {

// exchange
[[nodiscard]] Format container_format();
[[nodiscard]] Format x3p_format();
[[nodiscard]] Format sdf_format();
[[nodiscard]] Format gwy_format();
[[nodiscard]] Format gsf_format();

// arrays
[[nodiscard]] Format netcdf_format();
[[nodiscard]] Format npy_format();
[[nodiscard]] Format npz_format();
[[nodiscard]] Format mat_format();
[[nodiscard]] Format hdf5_format();
[[nodiscard]] Format datx_format();
[[nodiscard]] Format jpk_hdf5_format();
[[nodiscard]] Format topostats_format();

// scanning probes
[[nodiscard]] Format nanoscope_format();
[[nodiscard]] Format ibw_format();
[[nodiscard]] Format jpk_format();
[[nodiscard]] Format jpk_qi_format();
[[nodiscard]] Format park_format();
[[nodiscard]] Format mi_format();
[[nodiscard]] Format nanosurf_format();
[[nodiscard]] Format wsxm_format();
[[nodiscard]] Format mdt_format();
[[nodiscard]] Format nmm_format();
[[nodiscard]] Format nanonis_format();

// optical and stylus profilers
[[nodiscard]] Format opd_format();
[[nodiscard]] Format opdx_format();
[[nodiscard]] Format metropro_format();
[[nodiscard]] Format bcr_format();
[[nodiscard]] Format nms_format();
[[nodiscard]] Format frt_format();
[[nodiscard]] Format tmd_format();
[[nodiscard]] Format zmg_format();
[[nodiscard]] Format os3d_format();
[[nodiscard]] Format hgt_format();
[[nodiscard]] Format qep_format();
[[nodiscard]] Format plu_format();
[[nodiscard]] Format plux_format();
[[nodiscard]] Format al3d_format();
[[nodiscard]] Format sur_format();
[[nodiscard]] Format mnt_format();
[[nodiscard]] Format vk_format();
[[nodiscard]] Format zon_format();
[[nodiscard]] Format zag_format();
[[nodiscard]] Format lext_format();
[[nodiscard]] Format oir_format();
[[nodiscard]] Format poir_format();
[[nodiscard]] Format height_tiff_format();

// text and sheets
[[nodiscard]] Format mitutoyo_format();
[[nodiscard]] Format workbook_format();
[[nodiscard]] Format dektak_csv_format();
[[nodiscard]] Format hfm_format();
[[nodiscard]] Format dabam_format();
[[nodiscard]] Format matrix_text_format();
[[nodiscard]] Format xyz_format();
[[nodiscard]] Format xy_format();

}  // namespace setae::formats
