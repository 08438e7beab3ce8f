// SPDX-License-Identifier: GPL-3.0-or-later
#include "heights.hpp"

#include <map>

#include <fmt/format.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/shared_ptr.h>
#include <nlohmann/json.hpp>

#include "opened_file.hpp"
#include "setae/answers/contents_fields.hpp"
#include "setae/answers/diagnosis.hpp"
#include "setae/answers/processed_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"
#include "setae/study/pipeline_file.hpp"

namespace setae::python {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// A Python object that can be released from any thread.
std::shared_ptr<nb::object> shared_object(nb::object object) {
    return {new nb::object(std::move(object)), [](nb::object* owned) {
                if (!nb::is_alive()) return;
                const nb::gil_scoped_acquire locked;
                delete owned;
            }};
}

/// Heights after a pipeline, and the record of the steps.
struct Processed {
    std::shared_ptr<Heights> heights;
    std::string json;  ///< as printed by `setae level --json`
};

Processed as_processed(answers::ProcessedFile processed, const processing::Pipeline& pipeline) {
    const answers::ProcessingRecords records{study::step_lines(pipeline), {answers::record_of(processed)}};
    return {std::make_shared<Heights>(std::move(processed.result.measurement)),
            output::as_text(output::described(records))};
}

/// The channels of a request: of a container all channels of heights, of other files the first.
std::vector<std::size_t> meant_channels(const Item& item, bool all) {
    return formats::chosen_channels(item.path, open_and_keep(item), item.request.file.channel, all);
}

Processed process(const Item& item) {
    const auto pipeline = item.request.processing.pipeline();
    if (!item.heights)
        return as_processed(
            answers::processed_file(item.path, item.request.file.read_options(), item.request.file.channel, pipeline),
            pipeline);
    answers::ProcessedFile processed{
        .file = item.path, .channel = {}, .before = item.heights->measurement(), .result = {}};
    processed.result = processing::apply(pipeline, processed.before, study::measurement_loader());
    return as_processed(std::move(processed), pipeline);
}

std::shared_ptr<Heights> read(const Item& item) {
    const auto channels = kept_or_opened(item);
    const auto chosen = formats::chosen_channels(item.path, channels, item.request.file.channel).front();
    return std::make_shared<Heights>(channels[chosen].read());
}

void bind_request(nb::module_& module) {
    using Request = answers::SurfaceRequest;
    nb::class_<Item>(module, "Item")
        .def(
            "__init__",
            [](Item* item, const std::string& path, std::shared_ptr<Heights> heights) {
                new (item) Item{path, std::move(heights), {}};
            },
            nb::arg("path"), nb::arg("heights").none() = nb::none())
        .def_ro("path", &Item::path)
        .def(
            "set_file",
            [](Item& item, const std::string& size, const std::string& unit, const std::string& as,
               std::optional<std::string> channel, bool keep_values) {
                item.request.file = {size, unit, as, std::move(channel), keep_values};
            },
            nb::arg("size"), nb::arg("unit"), nb::arg("layout"), nb::arg("channel").none(), nb::arg("keep_values"))
        .def(
            "set_processing",
            [](Item& item, const std::string& file, const std::vector<std::string>& steps) {
                item.request.processing = {file, steps};
            },
            nb::arg("pipeline"), nb::arg("steps"))
        .def(
            "set_instrument",
            [](Item& item, const std::string& instrument, const std::string& tip_radius, const std::string& resolution,
               const std::string& trend) {
                Request& request = item.request;
                request.instrument = instrument;
                request.tip_radius = tip_radius;
                request.resolution = resolution;
                request.trend = trend;
                (void)request.input(item.path);  // throws for wrong options
            },
            nb::arg("instrument"), nb::arg("tip_radius"), nb::arg("resolution"), nb::arg("trend"));
}

}  // namespace

Heights::Heights(topography::Measurement measurement)
    : own_(std::make_shared<topography::Measurement>(std::move(measurement))) {}

Heights::Heights(nb::object given, const std::vector<double>& size, bool periodic, const std::string& name)
    : given_(shared_object(given)) {
    const auto array = nb::cast<ReadOnly>(given);
    data_ = array.data();
    const auto extents = array.ndim();
    if (extents != 1 && extents != 2)
        throw InvalidArgument(fmt::format("an array of {} dimensions; expected one (a line) or two (a map)", extents));
    if (size.size() != extents)
        throw InvalidArgument(fmt::format("{} sizes for an array of {} dimensions; expected one for each, such as {}",
                                          size.size(), extents, extents == 1 ? "\"5 um\"" : "\"5 um x 5 um\""));
    shape_ = {static_cast<Index>(array.shape(0)), extents == 2 ? static_cast<Index>(array.shape(1)) : 1};
    topography::Metadata about;
    about.name = about.file = name;
    if (extents == 2)
        own_ = std::make_shared<topography::Measurement>(HeightMap{{}, {size[0], size[1]}, periodic, about});
    else own_ = std::make_shared<topography::Measurement>(LineScan{{}, size[0], periodic, about});
    topography::validate(measurement());
}

nb::object Heights::array(nb::handle self) const {
    if (given_) return *given_;
    return std::visit(
        [&](const auto& m) -> nb::object {
            std::vector<std::size_t> shape{static_cast<std::size_t>(m.heights.rows())};
            if (m.heights.cols() != 1 || std::holds_alternative<HeightMap>(*own_))
                shape.push_back(static_cast<std::size_t>(m.heights.cols()));
            return nb::cast(ReadOnly(m.heights.data(), shape.size(), shape.data(), self));
        },
        *own_);
}

nb::object Heights::positions(nb::handle self) const {
    const auto* profile = std::get_if<Profile>(own_.get());
    return profile ? nb::cast(view(profile->positions, self)) : nb::none();
}

std::vector<double> Heights::size() const {
    if (const auto* map = std::get_if<HeightMap>(own_.get())) return {map->size[0], map->size[1]};
    if (const auto* scan = std::get_if<LineScan>(own_.get())) return {scan->size};
    return {std::get<Profile>(*own_).size()};
}

bool Heights::periodic() const {
    if (const auto* map = std::get_if<HeightMap>(own_.get())) return map->periodic;
    const auto* scan = std::get_if<LineScan>(own_.get());
    return scan && scan->periodic;
}

Index Heights::points() const {
    if (data_) return shape_[0] * shape_[1];
    return std::visit([](const auto& m) { return m.heights.size(); }, *own_);
}

const topography::Metadata& Heights::metadata() const { return topography::metadata(*own_); }

topography::Measurement Heights::measurement() const {
    auto copy = *own_;
    if (!data_) return copy;
    if (auto* map = std::get_if<HeightMap>(&copy))
        map->heights = Eigen::Map<const Array2D>(data_, shape_[0], shape_[1]);
    else std::get<LineScan>(copy).heights = Eigen::Map<const Array1D>(data_, shape_[0]);
    return copy;
}

bool are_few_heights(const std::vector<std::shared_ptr<Item>>& items) {
    constexpr Index few = 8192;
    if (items.size() != 1) return false;
    const auto& [path, heights, request] = *items.front();
    return heights && !request.processing.given() && heights->points() <= few;
}

study::SurfaceInput surface_of(const std::vector<std::shared_ptr<Item>>& items) {
    answers::SurfaceRequest files;
    for (const auto& item : items)
        if (!item->heights) files.files.push_back(item->path);
    if (items.size() == 1 && !items.front()->heights) {
        static_cast<answers::MeasurementRequest&>(files) = items.front()->request;
        return files.surface();
    }
    if (items.empty()) return files.surface();  // throws: a measurement is expected
    if (!files.files.empty() && files.is_spectrum())
        throw InvalidArgument(files.files.front() +
                              ": the table of a spectrum describes a whole surface; give no other measurement with it");
    study::SurfaceInput surface;
    surface.name = "surface";
    for (const auto& item : items) {
        surface.measurements.push_back(item->request.input(item->path));
        if (item->heights)
            surface.measurements.back().in_memory.read = [heights = item->heights] { return heights->measurement(); };
    }
    return surface;
}

std::vector<topography::Measurement> measurements_of(const Item& item) {
    auto found = item.heights ? std::vector{item.heights->measurement()}
                              : answers::measurements_of(item.path, item.request.file);
    const auto pipeline = item.request.processing.pipeline();
    if (pipeline.empty()) return found;
    for (auto& measurement : found)
        measurement = processing::apply(pipeline, std::move(measurement), study::measurement_loader()).measurement;
    return found;
}

processing::PipelineResult prepared_of(const Item& item) {
    auto measurement =
        item.heights ? item.heights->measurement() : answers::measurements_of(item.path, item.request.file).front();
    const auto options = item.heights ? formats::ReadOptions{} : item.request.file.read_options();
    return processing::apply(item.request.processing.pipeline(), std::move(measurement),
                             study::measurement_loader(options));
}

void bind_heights(nb::module_& module) {
    nb::class_<Heights>(module, "Heights")
        .def(nb::init<nb::object, const std::vector<double>&, bool, const std::string&>(), nb::arg("array"),
             nb::arg("size"), nb::arg("periodic"), nb::arg("name"))
        .def_prop_ro("array", [](nb::handle self) { return nb::cast<const Heights&>(self).array(self); })
        .def_prop_ro("positions", [](nb::handle self) { return nb::cast<const Heights&>(self).positions(self); })
        .def_prop_ro("size", &Heights::size)
        .def_prop_ro("periodic", &Heights::periodic)
        .def_prop_ro("name", [](const Heights& heights) { return heights.metadata().name; })
        .def_prop_ro("unit", [](const Heights& heights) { return heights.metadata().unit; })
        .def_prop_ro("attributes", [](const Heights& heights) { return heights.metadata().attributes; })
        .def_prop_ro("alerts", [](const Heights& heights) {
            return output::as_text(output::to_json(heights.metadata().alerts));
        });
    nb::class_<Processed>(module, "Processed").def_ro("heights", &Processed::heights).def_ro("json", &Processed::json);
    bind_request(module);
    module.def("lengths", &answers::lengths_of, nb::arg("text"), "'5 um x 5 um' in metres");
    module.def(
        "read", [](const Item& item) { return unlocked([&](const auto&) { return read(item); }); }, nb::arg("item"),
        "heights of the chosen channel");
    module.def(
        "process", [](const Item& item) { return unlocked([&](const auto&) { return process(item); }); },
        nb::arg("item"), "heights of the chosen channel after its steps");
    module.def("channels", &meant_channels, nb::arg("item"), nb::arg("all"));
    module.def(
        "contents",
        [](const std::vector<std::string>& paths, const Item& about, std::optional<bool> heights) {
            return unlocked([&](const auto&) {
                answers::ContentsRequest request{
                    .paths = paths, .questions = about.request.file.questions(), .channel = about.request.file.channel};
                if (heights) (*heights ? request.heights : request.no_heights) = true;
                return output::as_text(output::described(answers::contents(request)));
            });
        },
        nb::arg("paths"), nb::arg("about"), nb::arg("heights").none(), "as printed by `setae info --json`");
    module.def("steps", &answers::step_names, "names of the steps for Scan.process()");
}

}  // namespace setae::python
