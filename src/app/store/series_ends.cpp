// SPDX-License-Identifier: Apache-2.0
#include "app/store/series_ends.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/text.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

constexpr std::size_t k_shown = 80;  // characters shown of an invalid line

class Row {
  public:
    Row(const std::vector<std::string>& names, const std::string& line, const std::string& path)
        : names_(names), path_(path), words_(words_of(trimmed(line))) {
        for (const std::string& word : words_) {
            if (words_.size() == names_.size() && number_from_text(word)) continue;
            throw Error(ErrorKind::input,
                        Problem{"a row is not a list of numbers, one for each column", path_,
                                elided(valid_utf8(line), k_shown), joined(names_, ","), "The file is damaged"});
        }
    }
    [[nodiscard]] std::optional<double> find(const std::string& name) const {
        const auto found = std::find(names_.begin(), names_.end(), name);
        if (found == names_.end()) return std::nullopt;
        return number_from_text(words_.at(static_cast<std::size_t>(found - names_.begin())));
    }
    [[nodiscard]] double value(const std::string& name) const {
        if (const auto number = find(name)) return *number;
        throw Error(ErrorKind::input,
                    Problem{"has no column " + name, path_, elided(valid_utf8(joined(names_, ",")), k_shown), "",
                            "The file is damaged or not from a run"});
    }

  private:
    const std::vector<std::string>& names_;
    const std::string& path_;
    std::vector<std::string> words_;
};

}  // namespace

SeriesEnds read_series_ends(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string header, first, last, line;
    std::getline(file, header);
    bool whole = true;
    while (std::getline(file, line)) {
        whole = !file.eof();  // a last line without its end is incomplete
        if (first.empty()) first = line;
        last = line;
    }
    if (!whole || first.empty())
        throw Error(ErrorKind::input, Problem{whole ? "has no rows" : "is cut off in the middle of a row", path, "", "",
                                              "The file is damaged"});
    const std::vector<std::string> names = words_of(trimmed(header));
    const Row begin(names, first, path), end(names, last, path);
    SeriesEnds ends;
    ends.simulated_seconds = end.value("time_s");
    ends.volume_left = end.value("volume_left_m3");
    ends.last_speed = end.value("max_speed_ms");
    const auto entered = end.find("volume_entered_m3");  // older results have none
    ends.volume = entered ? *entered : begin.value("volume_m3") + begin.value("volume_left_m3");
    return ends;
}

}  // namespace frana::app
