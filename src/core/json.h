// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace frana {

/// The shortest decimal text that reads back as the same double ("0.1", "1e+20"); "nan", "inf", "-inf"
/// otherwise.
std::string shortest_text(double value);

/// A text in JSON's quotes: control characters escaped, valid UTF-8 whatever its bytes are.
std::string json_quoted(std::string_view text);

/// Writes JSON in order, two spaces a level. Non-finite numbers become null, as JSON has no word for them.
/// Inside an object every value needs a key; inside an array the key is left empty.
class JsonWriter {
  public:
    JsonWriter& begin_object(std::string_view key = {});
    JsonWriter& end_object();
    JsonWriter& begin_array(std::string_view key = {});
    JsonWriter& end_array();
    JsonWriter& number(std::string_view key, double value);
    JsonWriter& integer(std::string_view key, std::int64_t value);
    JsonWriter& text(std::string_view key, std::string_view value);
    JsonWriter& boolean(std::string_view key, bool value);
    JsonWriter& null(std::string_view key);

    /// What was written, with a final line end; every object and array must have been ended.
    [[nodiscard]] std::string str() const;

  private:
    void place(std::string_view key);
    void open(std::string_view key, char bracket);
    void close(char bracket);

    std::string out_;
    std::vector<bool> has_items_;
};

}  // namespace frana
