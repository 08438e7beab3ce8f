// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/core/errors.hpp"

namespace setae::tests {

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A cell's XML: a number, an inline string, or a shared string by "s:INDEX".
[[nodiscard]] inline std::string xlsx_cell(const std::string& reference, const std::string& value) {
    if (value.starts_with("s:")) return fmt::format(R"(<c r="{}" t="s"><v>{}</v></c>)", reference, value.substr(2));
    const bool number =
        !value.empty() && (std::isdigit(static_cast<unsigned char>(value.front())) || value.front() == '-');
    return number ? fmt::format(R"(<c r="{}"><v>{}</v></c>)", reference, value)
                  : fmt::format(R"(<c r="{}" t="inlineStr"><is><t>{}</t></is></c>)", reference, value);
}

/// Cells by reference, row by row.
using SheetCells = std::vector<std::vector<std::pair<std::string, std::string>>>;

[[nodiscard]] inline std::string xlsx_sheet(const SheetCells& rows) {
    std::string data;
    for (const auto& row : rows) {
        data += "<row>";
        for (const auto& [reference, value] : row) data += xlsx_cell(reference, value);
        data += "</row>";
    }
    return R"(<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>)" + data +
           "</sheetData></worksheet>";
}

/// A workbook of sheets by name, with shared strings.
[[nodiscard]] inline std::string xlsx_file(const std::vector<std::pair<std::string, std::string>>& sheets,
                                           const std::vector<std::string>& strings = {}) {
    std::string list, relations;
    Members members;
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        list += fmt::format(R"(<sheet name="{}" sheetId="{}" r:id="rId{}"/>)", sheets[k].first, k + 1, k + 1);
        relations += fmt::format(R"(<Relationship Id="rId{}" Target="worksheets/sheet{}.xml"/>)", k + 1, k + 1);
        members.emplace_back(fmt::format("xl/worksheets/sheet{}.xml", k + 1), sheets[k].second);
    }
    std::string shared;
    for (const auto& text : strings) shared += fmt::format("<si>{}</si>", text);
    members.emplace_back("xl/workbook.xml", R"(<workbook xmlns:r="http://x"><sheets>)" + list + "</sheets></workbook>");
    members.emplace_back("xl/_rels/workbook.xml.rels", "<Relationships>" + relations + "</Relationships>");
    members.emplace_back("xl/sharedStrings.xml", "<sst>" + shared + "</sst>");
    return zip_archive(members);
}

/// Names with a unit each and three rows: force [mN] 1 to 3, displacement [um] 10 to 30, a remark.
[[nodiscard]] inline std::string xlsx_loop() {
    return xlsx_file({{"Notes", xlsx_sheet({{{"A1", "lens 3"}}})},
                      {"Loop", xlsx_sheet({{{"A1", "made today"}},
                                           {{"B3", "s:0"}, {"C3", "s:1"}, {"D3", "remark"}},
                                           {{"B4", "1"}, {"C4", "10.5"}, {"D4", "ok"}},
                                           {{"B5", "2"}, {"C5", "20"}, {"D5", "ok"}},
                                           {{"B6", "3"}, {"D6", "dust"}}})}},
                     {"<t>Force (mN)</t>", "<r><t>Displacement</t></r><r><t xml:space=\"preserve\"> [um]</t></r>"});
}

template <class Number>
std::string big_endian(const std::vector<Number>& values) {
    std::string bytes;
    for (const auto value : values) {
        auto one = bytes_of(std::vector<Number>{value});
        std::reverse(one.begin(), one.end());
        bytes += one;
    }
    return bytes;
}

/// Properties of a JPK segment: height = 1e-6 (0.5 raw + 1) m, deflection 0.001 raw + 0.25 V, 50 nm/V, 0.2 N/m, offset
/// 1e-9 m.
[[nodiscard]] inline std::string jpk_segment(const char* style, int points, bool shared) {
    const auto conversion = [](const std::string& channel, const char* slot, const char* base, double multiplier,
                               double offset) {
        const auto prefix = fmt::format("{}.conversion-set.conversion.{}.", channel, slot);
        return fmt::format(
            "{0}defined=true\n{0}base-calibration-slot={1}\n{0}scaling.type=linear\n{0}scaling.style=offsetmultiplier\n{0}scaling.multiplier={2}\n"
            "{0}scaling.offset={3}\n",
            prefix, base, multiplier, offset);
    };
    const auto channel = [&](const std::string& place, const char* dot, double multiplier, double offset) {
        return fmt::format(
            "{0}{1}encoder.type=signedshort\n{0}{1}encoder.scaling.type=linear\n{0}{1}encoder.scaling.style=offsetmultiplier\n"
            "{0}{1}encoder.scaling.multiplier={2}\n{0}{1}encoder.scaling.offset={3}\n{0}.conversion-set.conversions.base=volts\n",
            place, dot, multiplier, offset);
    };
    std::string text = fmt::format(
        "# made by a test\nforce-segment-header.num-points={}\nforce-segment-header.duration=0.5\n"
        "force-segment-header.settings.segment-settings.style={}\nforce-segment-header.time-stamp=2020-01-02 03\\:04\\:05\n"
        "channels.list=measuredHeight vDeflection\n",
        points, style);
    for (const char* name : {"measuredHeight", "vDeflection"})
        text += fmt::format("channel.{0}.data.file.name=channels/{0}.dat\n", name);
    const std::string height = shared ? "lcd-info.0" : "channel.measuredHeight",
                      deflection = shared ? "lcd-info.1" : "channel.vDeflection";
    const char* dot = shared ? "." : ".data.";
    std::string info = channel(height, dot, 0.5, 1.0) + conversion(height, "nominal", "volts", 1e-6, 0.0) +
                       channel(deflection, dot, 0.001, 0.25) +
                       conversion(deflection, "distance", "volts", 50e-9, 1e-9) +
                       conversion(deflection, "force", "distance", 0.2, 0.0);
    if (shared) return text + "channel.measuredHeight.lcd-info.*=0\nchannel.vDeflection.lcd-info.*=1\n\x01" + info;
    return text + info;
}

/// A force curve of two segments: heights 4, 2, 0 then 0, 2, 4; readings 0, 100, 200 then 200, 100, −50.
[[nodiscard]] inline std::string jpk_force_file(bool shared = false) {
    Members members{
        {"header.properties", "jpk-data-file=spm-forcefile\nforce-scan-series.description.instrument=N1\n"}};
    std::string common;
    const std::vector<std::vector<std::int16_t>> heights{{4, 2, 0}, {0, 2, 4}},
        readings{{0, 100, 200}, {200, 100, -50}};
    for (std::size_t k = 0; k < 2; ++k) {
        auto properties = jpk_segment(k == 0 ? "extend" : "retract", 3, shared);
        if (const auto cut = properties.find('\x01'); cut != std::string::npos) {
            common = properties.substr(cut + 1);
            properties.resize(cut);
        }
        const auto folder = fmt::format("segments/{}/", k);
        members.emplace_back(folder + "segment-header.properties", properties);
        members.emplace_back(folder + "channels/measuredHeight.dat", big_endian(heights[k]));
        members.emplace_back(folder + "channels/vDeflection.dat", big_endian(readings[k]));
    }
    if (shared) members.emplace_back("shared-data/header.properties", common);
    return zip_archive(members);
}

/// The same as programs of 2015 wrote it: no kind of file in the header, style and duration by reference.
[[nodiscard]] inline std::string jpk_force_file_of_2015() {
    auto segment = jpk_segment("extend", 3, true);
    auto common = segment.substr(segment.find('\x01') + 1);
    segment.resize(segment.find('\x01'));
    for (const char* own :
         {"force-segment-header.settings.segment-settings.style=extend\n", "force-segment-header.duration=0.5\n"})
        segment.erase(segment.find(own), std::string(own).size());
    segment += "force-segment-header.force-segment-header-info.*=4\n";
    common +=
        "force-segment-header-info.4.settings.segment-settings.style=extend\nforce-segment-header-info.4.duration=0.5\n";
    return zip_archive(
        {{"header.properties",
          "#Fri May 22 15:31:49 CEST 2015\ntype=force-scan-series\nforce-scan-series.header.position.x=1e-6\n"
          "force-scan-series.header.position.y=-2e-6\n"},
         {"segments/0/segment-header.properties", segment},
         {"segments/0/channels/measuredHeight.dat", big_endian<std::int16_t>({4, 2, 0})},
         {"segments/0/channels/vDeflection.dat", big_endian<std::int16_t>({0, 100, 200})},
         {"shared-data/header.properties", common}});
}

/// A curve of a map for jpk_map_file(): raw heights and readings of extension and retraction.
struct JpkMapCurve {
    long number = 0;
    double x = 0.0, y = 0.0;  ///< [m]
    std::vector<std::vector<std::int16_t>> heights{{4, 2, 0}, {0, 2, 4}}, readings{{0, 100, 200}, {200, 100, -50}};
};

/// The header of a map: columns × rows over 4 µm × 2 µm around (1 µm, −1 µm), turned by an angle.
[[nodiscard]] inline std::string jpk_map_header(int columns = 2, int rows = 1, double angle = 0.0, bool qi = false) {
    const std::string pattern = fmt::format("{}-map.position-pattern.", qi ? "quantitative-imaging" : "force-scan");
    return fmt::format("jpk-data-file={}\ntype={}-map\n{}type=grid-position-pattern\n",
                       qi ? "spm-quantitative-image-data-file" : "spm-force-scan-map-file",
                       qi ? "quantitative-imaging" : "force-scan", pattern) +
           fmt::format(
               "{0}grid.ilength={1}\n{0}grid.jlength={2}\n{0}grid.ulength=4e-6\n{0}grid.vlength=2e-6\n"
               "{0}grid.xcenter=1e-6\n{0}grid.ycenter=-1e-6\n{0}grid.theta={3}\n",
               pattern, columns, rows, angle);
}

/// A force map, or QI data: curves in folders of their numbers, conversions shared.
[[nodiscard]] inline std::string jpk_map_file(const std::vector<JpkMapCurve>& curves,
                                              const std::string& header = jpk_map_header()) {
    Members members{{"header.properties", header}};
    const std::string series = holds(header, "quantitative-imaging") ? "quantitative-imaging" : "force-scan";
    std::string common;
    for (const auto& curve : curves) {
        const auto index = fmt::format("index/{}/", curve.number);
        for (std::size_t k = 0; k < curve.heights.size(); ++k) {
            auto properties =
                jpk_segment(k == 0 ? "extend" : "retract", static_cast<int>(curve.heights[k].size()), true);
            common = properties.substr(properties.find('\x01') + 1);
            properties.resize(properties.find('\x01'));
            const auto folder = fmt::format("{}segments/{}/", index, k);
            members.emplace_back(folder + "segment-header.properties", properties);
            members.emplace_back(folder + "channels/measuredHeight.dat", big_endian(curve.heights[k]));
            members.emplace_back(folder + "channels/vDeflection.dat", big_endian(curve.readings[k]));
        }
        members.emplace_back(index + "header.properties",
                             fmt::format("{0}-series.header.position.x={1}\n{0}-series.header.position.y={2}\n", series,
                                         curve.x, curve.y));
    }
    members.emplace_back("shared-data/header.properties", common);
    return zip_archive(members);
}

/// A curve of a sphere of 1 mm on soft solids of that contact modulus [Pa], around 20: a dry approach and a retraction
/// that sticks by 15 nN; 160 samples a way, half a micrometre apart, contact in the middle.
[[nodiscard]] inline JpkMapCurve jpk_contact(long number, double x, double y, double contact_modulus) {
    constexpr int samples = 160, contact = 80;
    constexpr double stiffness = 0.2, pull = 1.5e-8;
    JpkMapCurve curve{.number = number, .x = x, .y = y, .heights = {{}, {}}, .readings = {{}, {}}};
    const auto reading = [&](double travel, bool sticks) {
        double deepest = std::max(travel, 0.0), shallowest = 0.0;
        const auto force = [&](double depth) {
            return 4.0 / 3.0 * contact_modulus * std::sqrt(1e-3) * std::pow(depth, 1.5);
        };
        for (int step = 0; step < 60; ++step) {  // the travel of the base is depth and deflection
            const double depth = 0.5 * (deepest + shallowest);
            (depth + force(depth) / stiffness > travel ? deepest : shallowest) = depth;
        }
        const double sticky = sticks && travel > -2e-6 && travel <= 2e-6 ? -pull : 0.0;
        const double volts = (force(0.5 * (deepest + shallowest)) + sticky) / stiffness / 50e-9;
        return static_cast<std::int16_t>(std::lround((volts - 0.25) / 0.001));
    };
    for (int i = 0; i < samples; ++i)
        for (const bool back : {false, true}) {
            const int down = back ? samples - 1 - i : i;
            curve.heights[back].push_back(static_cast<std::int16_t>(samples - down));
            curve.readings[back].push_back(reading(0.5e-6 * (down - contact), back));
        }
    return curve;
}

/// A section of a channel of Nanosurf's spectroscopy: 2 curves of 3 points, 16 bits signed, which stand for −range/2 to
/// range/2.
[[nodiscard]] inline std::string nanosurf_channel(int group, int channel, const char* frame, const char* name,
                                                  const char* unit, double range) {
    return fmt::format(
        "[DataSet-{}:{}]\nPoints=3\nLines=2\nFrame={}\nDim0Unit=m\nDim1Unit=\nDim2Name={}\nDim2Unit={}\nDim2Range={}\n"
        "Dim2Min={}\nSaveMode=Binary\nSaveBits=16\nSaveSign=Signed\nSaveOrder=Intel\n{}",
        group, channel, frame, name, unit, range, -0.5 * range,
        std::string_view(frame) == "Spec backward" ? "LineDim0Points=3\nLineDim1Points=2\n" : "");
}

/// Spectroscopy of Nanosurf: two curves, heights that fall on approach (1 µm over 2^16), deflections of 2^16 nm in all,
/// or volts of 6.5536 in all; 48 N/m, 30 nm/V.
[[nodiscard]] inline std::string nanosurf_force_file(const char* deflection_unit = "m") {
    const double range = std::string_view(deflection_unit) == "m" ? 65536e-9 : 6.5536;
    std::string head =
        "[DataSet]\nGroupCount=2\nGr0-Ch0=DataSet-0:0\nGr0-Ch1=DataSet-0:1\nGr1-Ch0=DataSet-1:0\nGr1-Ch1=DataSet-1:1\n"
        "[DataSet-Info]\nDate=07-08-2018\nCantilever type=Tap190\n"
        "[DataSet\\Calibration\\Cantilever]\nProp0=D[48]*[N/m]\nProp1=D[190000]*[Hz]\n"
        "[DataSet\\Calibration\\Scanhead]\nIn5=5,TipSignalDC,Deflection,m,3e-07,0\nIn16=17,TipSignalDC2,Deflection,N,1,0\n"
        "[DataSet\\Parameters\\Spectroscopy]\nFwModTime=D[0.3]*[s]\nBwModTime=D[0.6]*[s]\n"
        "[DataSet\\SpecInfos]\nSubSectionCount=2\nSubSection0=Setup\nSubSection1=Positions\n"
        "[DataSet\\SpecInfos\\Setup]\nSpecMode=Point\n"
        "[DataSet\\SpecInfos\\Positions]\nCount=2\nPoi0=1e-06;2e-06;0\nPoi1=3e-06;4e-06;0\n";
    for (int group = 0; group < 2; ++group) {
        const char* frame = group == 0 ? "Spec forward" : "Spec backward";
        head += nanosurf_channel(group, 0, frame, "Z-Axis", "m", 65536e-6) +
                nanosurf_channel(group, 1, frame, "Deflection", deflection_unit, range);
    }
    return head + "\n#!" +
           bytes_of(std::vector<std::int16_t>{4,  2,  0,  8,  6,  4,   // heights of approach
                                              0,  10, 20, 0,  30, 60,  // deflections
                                              0,  2,  4,  4,  6,  0,   // of retraction, the second of two points
                                              20, 10, -5, 60, 30, 0});
}

/// A force curve as Igor stores it: columns Raw, Defl, ZSnsr of five samples, floats of the order named.
[[nodiscard]] inline std::string igor_force_file(const std::string& note, bool big = false) {
    const auto put = [&](std::string& bytes, std::size_t at, auto value) {
        auto raw = bytes_of(std::vector<decltype(value)>{value});
        if (big) std::reverse(raw.begin(), raw.end());
        bytes.replace(at, raw.size(), raw);
    };
    const std::vector<float> numbers{0.f,   1e-6f,  2e-6f, 1e-6f,   0.f,   0.f,     0.f, 4e-9f,
                                     1e-9f, -2e-9f, 0.f,   1.5e-6f, 3e-6f, 1.5e-6f, 0.f};
    std::string bytes(384 + 4 * numbers.size(), '\0');
    put(bytes, 0, std::int16_t{5});
    put(bytes, 4, static_cast<std::int32_t>(320 + 4 * numbers.size()));
    put(bytes, 12, static_cast<std::int32_t>(note.size()));
    put(bytes, 40, std::int32_t{4 * 32});
    put(bytes, 76, static_cast<std::int32_t>(numbers.size()));
    put(bytes, 80, std::int16_t{2});
    put(bytes, 132, std::int32_t{5});
    put(bytes, 136, std::int32_t{3});
    for (std::size_t i = 0; i < numbers.size(); ++i) put(bytes, 384 + 4 * i, numbers[i]);
    std::uint16_t sum = 0;
    for (std::size_t at = 0; at < 384; at += 2) {
        const auto one = static_cast<unsigned char>(bytes[at]), two = static_cast<unsigned char>(bytes[at + 1]);
        sum = static_cast<std::uint16_t>(sum + (big ? one * 256 + two : two * 256 + one));
    }
    put(bytes, 2, static_cast<std::uint16_t>(-sum));
    bytes += note;
    for (std::string label : {"", "Raw", "Defl", "ZSnsr"}) {
        label.resize(32, '\0');
        bytes += label;
    }
    return bytes;
}

[[nodiscard]] inline std::string afm_workshop_file() {
    return "Force-Distance Curve\r\nFile Format:\t3\r\n\r\nDate:\tFriday, February 14, 2020\r\nForce Constant, nN/nm:\t2.5\r\nX, um:\t25.0\r\n\r\n"
           "Extend Z-Sense(nm),Extend Force(nN),Retract Z-Sense(nm),Retract Force(nN)\r\n100,1,120,40\r\n110,2,110,15\r\n120,40,,\r\n";
}

[[nodiscard]] inline std::string nt_mdt_file() {
    return "-40,5000\t1,25\t1,5\n-30,5000\t1,25\t1,25\n-20,5000\t1,00\t0,75\n-10,5000\t0,50\t0,50\n0,5000\t0,00\t-0,25\n";
}

/// Force curves of Nanoscope: `curves` of four samples out and three back, 0.1 N/m, 50 nm/V, 0.001 V an integer; curve
/// k reads 10 k more. The height is a ramp of 8 V of 20 nm/V, or with `sensor` a channel of 0.001 V of 1000 nm/V.
[[nodiscard]] inline std::string nanoscope_force_file(int curves = 1, bool sensor = false, int value_bytes = 2) {
    constexpr std::size_t first_block = 4096;
    const auto length = static_cast<std::size_t>(7 * curves * value_bytes);
    const auto image = [&](std::size_t offset, const char* name, const char* sensitivity) {
        return fmt::format(
            "\\*Ciao force image list\r\n\\Data offset: {}\r\n\\Data length: {}\r\n\\Bytes/pixel: {}\r\n\\Samps/line: 4 "
            "3\r\n\\Spring Constant: 0.1\r\n\\@4:Image Data: S [Internal] \"{}\"\r\n\\@4:Z scale: V [{}] (0.001000000 "
            "V/LSB) 65.536 V\r\n\\@4:Ramp size: V [Sens. Zsens] (0.006713867 V/LSB) 8.000000 V\r\n",
            offset, length, value_bytes, name, sensitivity);
    };
    std::string file =
        "\\*Force file list\r\n\\Version: 0x08150300\r\n\\Date: 10:11:12 AM Mon Jan 05 2026\r\n\\*Scanner list\r\n"
        "\\@Sens. Zsens: V 20.00000 nm/V\r\n\\*Ciao scan list\r\n\\Scan Size: 2000 nm\r\n\\@Sens. DeflSens: V 50.00000 "
        "nm/V\r\n\\@Sens. ZsensSens: V 1000.000 nm/V\r\n\\*Ciao force list\r\n\\force/line: 2\r\n\\Trigger mode: Relative\r\n" +
        image(first_block, "Deflection Error", "Sens. DeflSens");
    if (sensor) file += image(first_block + length, "Height Sensor", "Sens. ZsensSens");
    file += "\\*File list end\r\n\x1a";
    file.resize(first_block, '\0');
    const auto put = [&](int value) {
        if (value_bytes == 2) file += bytes_of(std::vector<std::int16_t>{static_cast<std::int16_t>(value)});
        else file += bytes_of(std::vector<std::int32_t>{value * 65536});
    };
    // from the deepest point outwards, first on approach, then on retraction
    for (int k = 0; k < curves; ++k)
        for (const int reading : {300, 100, 0, 0, 300, 50, -80}) put(reading + 10 * k);
    for (int k = 0; sensor && k < curves; ++k)
        for (const int height : {40, 30, 20, 10, 40, 25, 10}) put(height);
    return file;
}

/// Text that JPK's data processing exports: one curve, or two with an index; heights fall on approach.
[[nodiscard]] inline std::string jpk_text_file(int curves = 1, const char* unit = "N") {
    std::string text = "# TEXT EXPORT\n# data-description.instrument: N1\n";
    for (int k = 0; k < curves; ++k)
        for (const bool back : {false, true}) {
            text += fmt::format(
                "# index: {}\n# xPosition: {}\n# yPosition: 2.0E-6\n# date: Mon Jan 05 10:11:12 GMT 2026\n#\n# segmentIndex: "
                "{}\n# segment: {}\n# columns: vDeflection height measuredHeight time\n# fancyNames: \"Vertical Deflection\" "
                "\"Height\" \"Height (measured)\" \"Segment Time\"\n# sensitivity: 5.0E-8\n# springConstant: 0.1\n# units: {} m m "
                "s\n#\n",
                curves == 1 ? -1 : k, 1e-6 * k, back ? 1 : 0, back ? "retract" : "extend", unit);
            for (int i = 0; i < 4; ++i) {
                const int down = back ? 3 - i : i;
                text += fmt::format("{} {} {} {}\n", 1e-9 * (down + 10 * k), 5e-6, 4e-6 - 1e-6 * down, 0.25 * i);
            }
            text += "\n";
        }
    return text;
}

}  // namespace setae::tests
