// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/write_figures.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>

#include <fmt/format.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/cache/key.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/study/provenance.hpp"

namespace setae::study_figures {
namespace {

std::string on_one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

}  // namespace

std::string command_of(const StudyFigure& figure, const std::string& study, FigureWidth width) {
    if (!figure.command.empty()) return figure.command;
    return fmt::format("setae plot {} --figure {}{} -o {}.svg", shell_word(study), shell_word(figure.identifier),
                       width == FigureWidth::single_column ? " --width single" : "", shell_word(figure.name));
}

std::string data_of(const StudyFigure& figure, const std::string& study, FigureWidth width) {
    return on_one_line(fmt::format("# title: {}", figure.title)) + "\n" +
           on_one_line(fmt::format("# figure: {}", figure.identifier)) + "\n" +
           on_one_line(fmt::format("# caption: {}", figure.caption)) + "\n" +
           fmt::format("# written by: setae {}\n", study::version()) +
           on_one_line(fmt::format("# command: {}", command_of(figure, study, width))) + "\n" +
           figures::data_text(figure.figure);
}

std::string bytes_of(const StudyFigure& figure, const std::string& ending, const cache::Store* store) {
    const auto program = store && store->enabled() ? figures::drawing_program() : std::string();
    if (program.empty()) return figures::drawn(figure.figure, ending);
    const auto key = cache::KeyBuilder("figure")
                         .add("script", figures::gnuplot_script(figure.figure, ending, "figure"))
                         .add("ending", ending)
                         .add("gnuplot", program)
                         .key();
    if (auto kept = store->find(key)) return *kept;
    auto bytes = figures::drawn(figure.figure, ending);
    store->keep(key, bytes);
    return bytes;
}

std::vector<WrittenFigure> write_figures(const std::vector<StudyFigure>& figures, const WriteOptions& options) {
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    if (error)
        throw FileError(fmt::format("{}: cannot be made: {}; check that the folder above is writable", options.folder,
                                    error.message()));
    std::vector<const StudyFigure*> drawable;
    for (const auto& figure : figures)
        if (figure.drawable()) drawable.push_back(&figure);
    const std::size_t endings = options.endings.size();
    std::vector<std::string> errors(drawable.size() * endings);
    std::vector<std::size_t> left(drawable.size(), endings);
    std::mutex telling;
    const auto cancelled = [&options] { return options.cancelled && *options.cancelled; };
    parallel::for_each_index(errors.size(), options.threads, [&](std::size_t job) {
        if (cancelled()) return;
        const auto& figure = *drawable[job / endings];
        const auto& ending = options.endings[job % endings];
        try {
            const auto file = figure.name + "." + ending;
            const auto path =
                options.path_of ? options.path_of(file) : (std::filesystem::path(options.folder) / file).string();
            bytes::write_whole_file(path, ending == "csv" ? data_of(figure, options.study, options.width)
                                                          : bytes_of(figure, ending, options.store));
        } catch (const std::exception& failure) {
            errors[job] = reason_of(failure);
        }
        const std::scoped_lock lock(telling);
        if (--left[job / endings] == 0 && options.progress) options.progress(figure.name);
    });
    if (cancelled()) throw Cancelled("stopped before all figures were drawn");
    std::vector<WrittenFigure> written;
    for (std::size_t i = 0; i < drawable.size(); ++i) {
        WrittenFigure result{.name = drawable[i]->name};
        for (std::size_t k = 0; k < endings; ++k) {
            const auto& failure = errors[i * endings + k];
            if (failure.empty()) result.files.push_back(result.name + "." + options.endings[k]);
            // equal for every ending where there is no gnuplot: reported once
            else if (result.error.find(failure) == std::string::npos)
                result.error += (result.error.empty() ? "" : "; ") + failure;
        }
        written.push_back(result);
    }
    return written;
}

}  // namespace setae::study_figures
