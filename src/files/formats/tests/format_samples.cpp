// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_samples.hpp"

#include <functional>

namespace setae::formats::tests {

std::vector<FormatSample> format_samples() {
    const std::vector<std::function<std::vector<FormatSample>()>> makers{
        // exchange
        container_samples,
        x3p_samples,
        sdf_samples,
        gwy_samples,
        gsf_samples,

        // arrays
        netcdf_samples,
        npy_samples,
        npz_samples,
        mat_samples,
        hdf5_samples,
        datx_samples,
        jpk_hdf5_samples,
        topostats_samples,

        // scanning probes
        nanoscope_samples,
        ibw_samples,
        jpk_samples,
        jpk_qi_samples,
        park_samples,
        mi_samples,
        nanosurf_samples,
        wsxm_samples,
        mdt_samples,
        nmm_samples,
        nanonis_samples,

        // optical and stylus profilers
        opd_samples,
        opdx_samples,
        metropro_samples,
        bcr_samples,
        nms_samples,
        frt_samples,
        tmd_samples,
        zmg_samples,
        os3d_samples,
        qep_samples,
        plu_samples,
        plux_samples,
        al3d_samples,
        sur_samples,
        mnt_samples,
        vk_samples,
        zon_samples,
        zag_samples,
        lext_samples,
        oir_samples,
        poir_samples,
        height_tiff_samples,

        // text and sheets
        mitutoyo_samples,
        workbook_samples,
        dektak_csv_samples,
        hfm_samples,
        dabam_samples,
        matrix_text_samples,
        xyz_samples,
        xy_samples,
    };
    std::vector<FormatSample> samples;
    for (const auto& make : makers)
        for (auto& sample : make()) samples.push_back(std::move(sample));
    return samples;
}

Array2D lopsided_heights(Index nx, Index ny, double unit) {
    Array2D heights(nx, ny);
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            heights(i, j) = unit * static_cast<double>(1 + 3 * i + 100 * j + (7 * i + 13 * j) % 11);
    return heights;
}

}  // namespace setae::formats::tests
