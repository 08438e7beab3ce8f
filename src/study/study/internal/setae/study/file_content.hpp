// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/formats/channel.hpp"
#include "setae/imaging/picture_content.hpp"
#include "setae/study/study.hpp"

namespace setae::study {

/// Kind of a file for setae.
enum class FileKind {
    topography,   ///< heights of a map, a line or a contour
    container,    ///< measurements with an index
    micrograph,   ///< a picture in which a contour may be traced
    recording,    ///< frames of a contact
    loop,         ///< force against displacement or contact radius
    force_curve,  ///< force curve of a scanning probe at one point
    spectrum,     ///< a table of a power spectrum
    study,
    recipe,    ///< recipe of `setae lab make`
    mapping,   ///< names of a foreign table's columns
    pipeline,  ///< processing steps
};

/// "topography" …, as scripts read it.
[[nodiscard]] std::string name(FileKind kind);
/// The commands that read a file of a kind, the most relevant first: "setae psd", "setae params" ….
[[nodiscard]] std::vector<std::string> commands_for(FileKind kind);

/// A file and its contents, as far as known without reading heights.
struct FileContent {
    std::string file;
    FileKind kind = FileKind::topography;
    std::string format;  ///< identifier in the lists of formats; empty where there is but one
    /// for topographies and containers, and for curves that may be heights
    std::vector<formats::Channel> channels = {};
    std::optional<imaging::PictureContent> picture = {};  ///< for micrographs and recordings
    std::optional<Table> table = {};                      ///< for loops, force curves and spectra, in SI
    std::optional<Study> study = {};
    std::size_t curves = 1;  ///< for a file of force curves, the first of which is `table`
    /// metadata that loops and force curves lack and fits need: "sphere_radius" …
    std::vector<std::string> missing = {};
    std::string note = {};  ///< further remark for the reader
};

/// Metadata that a file may not contain.
struct FileQuestions {
    formats::ReadOptions heights;
    bool is_spectrum = false;  ///< whether the file is a table of a spectrum, regardless of its header
    tables::SpectrumUnits spectrum = {};
};

/// Determines the kind of a file, TOML by its keys and all others by their content.
/// @throws FileError; FormatError with the reason for a file that setae cannot read, or a damaged one.
[[nodiscard]] FileContent file_content(const std::string& file, const FileQuestions& questions = {});

/// A path that cannot be looked into, and why.
struct UnreadablePath {
    std::string path, reason;
};

/// Files, those of folders and the folders in them one by one.
struct FoundFiles {
    std::vector<std::string> files;
    std::vector<std::string> own;            ///< for folders: figures, tables and reports that setae wrote
    std::vector<UnreadablePath> unreadable;  ///< folders that cannot be listed, or that hold no file
};

/// Whether a path is a folder, or a ZIP archive that is none of the formats setae reads: such an archive is a folder of
/// its members wherever a folder is taken.
[[nodiscard]] bool is_folder(const std::string& path);

/// The files of paths, in the order of the paths, those of a folder by name: its files, then its folders. Hidden files
/// are left out, and links to folders within a folder are not followed; outputs of setae are listed separately. A path
/// that is no folder is a file, whether it exists or not.
[[nodiscard]] FoundFiles found_files(const std::vector<std::string>& paths);

}  // namespace setae::study
