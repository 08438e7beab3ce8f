// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiff_micrograph.hpp"

#include <algorithm>
#include <vector>

#include "micrograph_building.hpp"
#include "setae/core/errors.hpp"
#include "tiff_calibration.hpp"
#include "tiff_stack.hpp"

namespace setae::imaging {
namespace {

constexpr std::uint16_t tag_subfile = 254;
constexpr std::uint64_t reduced_or_mask = 1 | 4;

std::vector<std::size_t> images_of(const TiffStack& stack) {
    bool olympus = false;
    for (std::size_t i = 0; i < stack.size(); ++i) olympus = olympus || has_olympus_block(stack.page(i));
    std::vector<std::size_t> images;
    long widest = 0;
    for (std::size_t i = 0; i < stack.size(); ++i) {
        const auto& page = stack.page(i);
        const bool reduced = (stack.number(page, tag_subfile).value_or(0) & reduced_or_mask) != 0;
        if (reduced || (olympus && !has_olympus_block(page))) continue;
        images.push_back(i);
        widest = std::max(widest, stack.size_of(i).width);
    }
    std::erase_if(images, [&](std::size_t i) { return 2 * stack.size_of(i).width < widest; });
    if (images.empty()) images.push_back(0);
    return images;
}

}  // namespace

Micrograph read_tiff(const bytes::Source& file, const MicrographOptions& options) {
    auto micrograph = unread_micrograph(file, "tiff");
    const TiffStack stack(file);
    for (std::size_t i = 0; i < stack.size(); ++i)  // it is unknown whether it is a thumbnail or the image
        if (const auto fault = stack.fault(i); !fault.empty()) throw FormatError(file.name, {}, fault);
    const auto images = images_of(stack);
    const auto index = images[choose_image(micrograph, images.size(), options)];
    const auto& page = stack.page(index);
    if (!page.lost.empty()) throw FormatError(file.name, {}, page.lost);
    const auto damaged = [&](const std::string& what) { return FormatError(file.name, {.offset = page.offset}, what); };
    const auto stated = stack.size_of(index);
    const auto size = picture_size(stack.file(), page.offset, static_cast<std::uint64_t>(stated.width),
                                   static_cast<std::uint64_t>(stated.height), options);
    auto frame = stack.read(index);
    if (!frame.fault.empty()) throw damaged(frame.fault);
    if (frame.pixels.cols() != size.width || frame.pixels.rows() != size.height)
        throw damaged("the decoded picture has another size than its directory states; the file is damaged");
    micrograph.pixels = std::move(frame.pixels);
    read_tiff_calibration(stack, index, micrograph);
    return micrograph;
}

}  // namespace setae::imaging
