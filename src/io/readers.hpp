// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "setae/io/channel.hpp"
#include "setae/io/format.hpp"
#include "setae/io/source.hpp"

/// One pair of functions a format: whether bytes belong to it, and its channels. formats.cpp gathers them in the table.
namespace setae::io {

[[nodiscard]] Match detect_container(std::string_view head, const Source& source);
[[nodiscard]] std::vector<Channel> open_container(const Source& source, const ReadOptions& options);

[[nodiscard]] Match detect_x3p(std::string_view head, const Source& source);
[[nodiscard]] std::vector<Channel> open_x3p(const Source& source, const ReadOptions& options);

[[nodiscard]] Match detect_nanoscope(std::string_view head, const Source& source);
[[nodiscard]] std::vector<Channel> open_nanoscope(const Source& source, const ReadOptions& options);

[[nodiscard]] Match detect_netcdf(std::string_view head, const Source& source);
[[nodiscard]] std::vector<Channel> open_netcdf(const Source& source, const ReadOptions& options);

[[nodiscard]] Match detect_npy(std::string_view head, const Source& source);
[[nodiscard]] std::vector<Channel> open_npy(const Source& source, const ReadOptions& options);

[[nodiscard]] Match detect_matrix_text(std::string_view head, const Source& source);
[[nodiscard]] std::vector<Channel> open_matrix_text(const Source& source, const ReadOptions& options);

[[nodiscard]] Match detect_xy(std::string_view head, const Source& source);
[[nodiscard]] std::vector<Channel> open_xy(const Source& source, const ReadOptions& options);

}  // namespace setae::io
