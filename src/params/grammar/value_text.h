// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace frana {

/// Returns the number of letters to insert, delete, replace or swap with their neighbour to turn one word into the
/// other.
int edit_distance(std::string_view a, std::string_view b);

/// Returns the "section.key" most likely meant: nearest by spelling, or the same key in another section. Empty if none
/// is near enough to help.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

/// Returns the text without white space at either end.
std::string trimmed(const std::string& text);

/// Reads a finite number with a decimal point from the whole text; none otherwise.
std::optional<double> number_from_text(const std::string& text);
std::optional<std::int64_t> integer_from_text(const std::string& text);
/// What to write instead of a text that is no number; empty without a comma between its digits.
std::string comma_remedy(const std::string& text);
/// Reads on, true, yes, 1 and off, false, no, 0.
std::optional<bool> boolean_from_text(const std::string& text);

/// Returns the parts between commas or white space, without empty ones.
std::vector<std::string> words_of(const std::string& text);

std::string joined(const std::vector<std::string>& words, const std::string& separator);

struct Size {
    int width = 0;
    int height = 0;
    double dots_per_inch = 150;  ///< of the printed picture
    std::string paper{};         ///< "A4-portrait"; empty: a size in pixels
    bool turns = false;          ///< upright where the flow of a map is taller than wide
};
/// Whether the size is that of a sheet of paper, on which a map has a scale.
inline bool is_paper(const Size& size) {
    return !size.paper.empty();
}
/// Returns the size of a map of ground this wide and high: one that turns is upright from the shape on at which an
/// upright page's frame shows the ground at the greater scale.
Size size_for_ground(Size size, double width, double height);
/// Returns the sheets of paper of maps: "A4, A3, A4-portrait, ..."; without a direction the flow turns it.
std::string paper_names();
/// Returns the sizes that size_from_text accepts, for messages.
std::string size_forms();
/// Reads a picture's size in pixels: "1600x1200", or an ISO 216 page with its resolution: "A4", "A3-portrait@300".
/// "auto" is 1600x1200; it and pages without a direction turn with the flow.
std::optional<Size> size_from_text(const std::string& text);

/// Viewing direction, in degrees.
struct CameraText {
    double azimuth = 0, elevation = 35, zoom = 1;
};
inline constexpr const char* k_cameras = "AZIMUTH, ELEVATION[, ZOOM]: 0 to 360, 1 to 89, 0.1 to 20";
/// Reads "210, 30" or "210, 30, 1.5".
std::optional<CameraText> camera_from_text(const std::string& text);

}  // namespace frana
