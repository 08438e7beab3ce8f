// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "setae/formats/channel.hpp"
#include "setae/processing/pipeline.hpp"
#include "setae/study/file_content.hpp"
#include "setae/study/surface_analysis.hpp"

/// What a user asks, in texts as they are typed, and what is answered. Empty texts leave a thing open.
namespace setae::answers {

/// "1 mm x 1 mm" or "2 mm" [m]. @throws InvalidArgument for more than two lengths, and as parse_quantity().
[[nodiscard]] std::vector<double> lengths_of(const std::string& text);

/// What files may leave open.
struct FileRequest {
    std::string size;  ///< "1 mm x 1 mm" or "2 mm"
    std::string unit;  ///< "um"; "mm, um": of x, then of heights; of a table of a spectrum "1/um, nm3"
    std::string as;    ///< "matrix", "columns" or "spectrum"
    formats::ChannelChoice channel;
    bool keep_values = false;  ///< values that mark missing heights stay heights

    /// @throws InvalidArgument for a malformed size, and for a table of a spectrum, which holds no heights.
    [[nodiscard]] formats::ReadOptions read_options() const;
    /// The same of files of any kind. @throws InvalidArgument for malformed texts.
    [[nodiscard]] study::FileQuestions questions() const;

    friend bool operator==(const FileRequest&, const FileRequest&) = default;
};

/// Processing before analysis: the steps of a file, then those of the list, such as "despike threshold=5".
struct ProcessingRequest {
    std::string file;
    std::vector<std::string> steps;

    [[nodiscard]] bool given() const { return !file.empty() || !steps.empty(); }
    /// @throws as read_pipeline() and step_from_text() do.
    [[nodiscard]] processing::Pipeline pipeline() const;
};

/// How the files of one surface are read and prepared.
struct MeasurementRequest {
    FileRequest file;
    ProcessingRequest processing;
    std::string instrument, tip_radius, resolution, trend;

    /// One of them. @throws InvalidArgument for a malformed text.
    [[nodiscard]] study::MeasurementInput input(const std::string& path) const;
};

/// How a surface is analysed.
struct AnalysisRequest {
    std::string longest, shortest, window, contours, conversion;
    double memory = 2.0;  ///< GiB
    int resamples = 200;

    /// By the average over measurements, whose spectrum can be shown bin by bin. @throws InvalidArgument.
    [[nodiscard]] study::SurfaceAnalysisOptions analysis() const;
};

/// Files that are measurements of one surface, or the table of its spectrum.
struct SurfaceRequest : MeasurementRequest, AnalysisRequest {
    std::vector<std::string> files;

    /// Whether the one file is the table of a spectrum. @throws InvalidArgument for one among others.
    [[nodiscard]] bool is_spectrum() const;
    /// @throws InvalidArgument for a malformed text; as is_spectrum().
    [[nodiscard]] study::SurfaceInput surface() const;
};

/// All alerts of a surface and its measurements.
[[nodiscard]] std::vector<Alert> alerts_of(const study::SurfaceResult& surface);

}  // namespace setae::answers
