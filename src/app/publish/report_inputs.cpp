// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report_inputs.h"

#include <sstream>

#include "app/input/transform_report.h"
#include "app/text/number_text.h"
#include "core/words/number_pattern.h"

namespace frana::app {
namespace {

/// "Float32 in metre (assumed)", "300 x 270 of", "1 polygon"
std::string line_in(std::string line, const Words& words) {
    const std::string assumed = " (assumed)", in = " in ", area = " m2";
    if (line.ends_with(assumed))
        return line_in(line.substr(0, line.size() - assumed.size()), words) + " (" + words("assumed") + ")";
    if (const std::size_t at = line.find(in); at != std::string::npos)
        return words("{1} in {2}", {line.substr(0, at), words(line.substr(at + in.size()))});
    if (line.ends_with(area)) line.replace(line.size() - area.size(), area.size(), " m²");
    return NumberPattern(line).in(words);
}

}  // namespace

std::string role_in(const UsedFile& file, const Words& words) {
    const std::size_t colon = file.role.find(": ");  // "Zones: KEY"
    std::string role = colon == std::string::npos
                           ? words(file.role)
                           : words.labelled(words(file.role.substr(0, colon)), file.role.substr(colon + 2));
    if (!file.resampling.empty()) role += " (" + file.resampling + ")";
    return role;
}

std::string content_in(const UsedFile& file, const Words& words) {
    std::stringstream lines(file.content);
    std::string text;
    for (std::string line; std::getline(lines, line);) text += (text.empty() ? "" : "\n") + line_in(line, words);
    return text;
}

std::string operation_in(const UsedFile& file, const Words& words) {
    if (file.crs_label.empty()) return "";
    const std::string operation = transform_text(file.transform);
    if (operation == "none") return words("none needed");
    const double accuracy = file.transform.accuracy_m;
    if (accuracy < 0) return words("{1}; accuracy unknown", {operation});
    if (accuracy == 0) return words("{1}; exact", {operation});
    return words("{1}; accuracy {2} m", {operation, words.number(number_text(accuracy, 3))});
}

}  // namespace frana::app
