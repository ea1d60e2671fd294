// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/commands/command_line.h"
#include "app/pictures/map_source.h"
#include "core/error.h"

namespace frana::app {

/// Adds the options of `frana render` that override the style of the scene's pictures.
void add_style_options(CommandForm& form);

/// The problem of a value that is none of an option's words.
Problem not_one_of(const std::string& option, const std::string& value, const std::string& choices);

/// Overrides the style by the options; adds their problems.
void read_style(const boost::program_options::variables_map& values, MapStyle& style, Problems& problems);

/// Throws Error(input) if the content of a map does not fit its page at the chosen scale, with a scale and a sheet of
/// paper that fit.
void refuse_scale_that_does_not_fit(const MapSource& source, const MapLayer& layer, bool by_option);

}  // namespace frana::app
