// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/page.h"

#include <algorithm>
#include <utility>

namespace frana::render {

void Page::put(std::shared_ptr<const Image> picture, int left, int top) {
    parts_.push_back({left, top, std::move(picture), {}});
}

void Page::put(Image picture, int left, int top) {
    put(std::make_shared<const Image>(std::move(picture)), left, top);
}

void Page::put(const Page& other, int left, int top) {
    for (Part part : other.parts_) {
        part.left += left;
        part.top += top;
        parts_.push_back(std::move(part));
    }
}

Image Page::paint() const {
    for (const Part& part : parts_)
        if (!part.picture) part.drawing.rasterise();
    Image page(width_, height_);
    for (const Part& part : parts_) {
        if (!part.picture) {
            part.drawing.put(page, part.left, part.top);
            continue;
        }
        for (int row = 0; row < part.picture->height; ++row)
            std::copy_n(part.picture->pixel(0, row), 3 * static_cast<std::size_t>(part.picture->width),
                        page.pixel(part.left, part.top + row));
    }
    return page;
}

}  // namespace frana::render
