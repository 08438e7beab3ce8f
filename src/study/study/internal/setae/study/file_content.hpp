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

/// What a file is to setae.
enum class FileKind {
    topography,   ///< heights of a map, a line or a contour
    container,    ///< measurements with an index
    micrograph,   ///< a picture in which a contour may be traced
    recording,    ///< frames of a contact
    loop,         ///< force against displacement or contact radius
    force_curve,  ///< what a scanning probe recorded at a point
    spectrum,     ///< a table of a power spectrum
    study,
    recipe,    ///< what `setae lab make` makes data of
    mapping,   ///< names of a foreign table's columns
    pipeline,  ///< processing steps
};

/// "topography" …, as scripts read it.
[[nodiscard]] std::string name(FileKind kind);
/// The commands that take a file of a kind, the nearest first: "setae psd", "setae params" ….
[[nodiscard]] std::vector<std::string> commands_for(FileKind kind);

/// A file and what it holds, as far as that is known without reading heights.
struct FileContent {
    std::string file;
    FileKind kind = FileKind::topography;
    std::string format;                           ///< identifier in the lists of formats; empty where there is but one
    std::vector<formats::Channel> channels = {};  ///< of topographies and containers, and of curves that may be heights
    std::optional<imaging::PictureContent> picture = {};  ///< of micrographs and recordings
    std::optional<Table> table = {};                      ///< of loops, force curves and spectra, in SI
    std::optional<Study> study = {};
    std::size_t curves = 1;                 ///< of a file of force curves, the first of which is `table`
    std::vector<std::string> missing = {};  ///< what loops and force curves do not say and fits need: "sphere_radius" …
    std::string note = {};                  ///< what else a reader should know
};

/// What a file may leave open.
struct FileQuestions {
    formats::ReadOptions heights;
    bool is_spectrum = false;  ///< the file is a table of a spectrum, whatever its header says
    tables::SpectrumUnits spectrum = {};
};

/// Tells what a file is, TOML by its keys and all others by their content.
/// @throws FileError; FormatError with the reason for a file that is nothing setae reads, or a damaged one.
[[nodiscard]] FileContent file_content(const std::string& file, const FileQuestions& questions = {});

/// A path that cannot be looked into, and why.
struct UnreadablePath {
    std::string path, reason;
};

/// Files, those of folders and the folders in them one by one.
struct FoundFiles {
    std::vector<std::string> files;
    std::vector<std::string> own;            ///< of folders: figures, tables and reports that setae wrote
    std::vector<UnreadablePath> unreadable;  ///< folders that cannot be listed, or that hold no file
};

/// Whether a path is a folder, or a ZIP archive that is none of the formats setae reads: such an archive is a folder of
/// its members wherever a folder is taken.
[[nodiscard]] bool is_folder(const std::string& path);

/// The files that paths name, in the order of the paths, those of a folder by name: its files, then its folders. Hidden
/// files are left out, and links to folders are not followed where a folder holds them; outputs of setae stand apart.
/// What is no folder is a file, there or not.
[[nodiscard]] FoundFiles found_files(const std::vector<std::string>& paths);

}  // namespace setae::study
