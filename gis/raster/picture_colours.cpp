// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/picture_colours.h"

#include <cpl_string.h>
#include <gdal.h>
#include <gdal_utils.h>

#include <string>

namespace frana::gis {

GdalDataset in_colours(GDALDatasetH source) {
    GDALRasterBandH first = GDALGetRasterBand(source, 1);
    CPLStringList words;
    words.AddString("-of");
    words.AddString("VRT");
    if (GDALGetRasterColorTable(first) != nullptr) {
        words.AddString("-expand");
        words.AddString("rgba");
    } else {
        const int bands = GDALGetRasterCount(source);
        const bool grey = bands < 3;
        for (int k = 1; k <= 3; ++k) {
            words.AddString("-b");
            words.AddString(grey ? "1" : std::to_string(k).c_str());
        }
        const int last = grey ? 2 : 4;
        const bool alpha =
            bands >= last && GDALGetRasterColorInterpretation(GDALGetRasterBand(source, last)) == GCI_AlphaBand;
        if (alpha) {
            words.AddString("-b");
            words.AddString(std::to_string(last).c_str());
            words.AddString("-colorinterp_4");
            words.AddString("alpha");
        }
    }
    GDALTranslateOptions* options = GDALTranslateOptionsNew(words.List(), nullptr);
    int usage_error = 0;
    GdalDataset coloured(GDALTranslate("", source, options, &usage_error));
    GDALTranslateOptionsFree(options);
    return coloured;
}

}  // namespace frana::gis
