// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana::gis {

/// A member of an object in a JSON text.
struct JsonMember {
    std::string text;     ///< its value as in the text
    bool at_top = false;  ///< of the outermost object, or of each one if several follow each other
};

/// Finds the members of one name in JSON that is read in pieces and may be larger than the memory; those in objects
/// under the member `besides` are ignored. It accepts text that GDAL reads and strict parsers refuse: NaN, texts that
/// are not UTF-8, several documents in sequence.
class JsonMembers {
  public:
    JsonMembers(std::string name, std::string besides) : name_(std::move(name)), besides_(std::move(besides)) {}

    void read(const char* bytes, std::size_t count);
    /// Without repetitions, in their order.
    [[nodiscard]] const std::vector<JsonMember>& found() const noexcept { return found_; }

  private:
    void step(char c);
    void open(char c);
    void close();
    void end_value();

    struct Level {
        bool is_object = false, expects_key = false;
        bool left_out = false;
        std::string key = {};
    };

    std::string name_, besides_;
    std::vector<Level> levels_;
    std::string string_;  ///< the latest
    bool in_string_ = false, escaped_ = false;
    bool reading_ = false;  ///< a value
    std::size_t depth_of_text_ = 0;
    std::string text_;
    std::vector<JsonMember> found_;
};

}  // namespace frana::gis
