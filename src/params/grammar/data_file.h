// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/words/words.h"

namespace frana {

/// A data file of the share folder, or a user's own (a hazard scheme, a friction table): hands out its entries one by
/// one, and collects what is wrong with them.
class DataFile {
  public:
    /// @param label names the file in problems, @param guide the page that lists its keys
    /// Throws Error(input) if the file cannot be read as INI.
    DataFile(const std::string& path, std::string label, std::string guide, Problems& problems);

    void refuse(const std::string& what, const std::string& key, const std::string& value, const std::string& limit,
                const std::string& remedy);
    /// Returns the value of a key; none if the file does not have it.
    std::optional<std::string> taken(const std::string& key);
    std::string required(const std::string& key);
    /// A name and, as KEY-it and so on, what it is in other languages.
    std::string named(const std::string& key, OwnTexts& texts);
    /// Rising numbers greater than 0.
    std::vector<double> rising(const std::string& key, const std::string& text);
    /// Reads the title, the source, and the words of it that were read, of a struct with these members.
    template <class Described>
    void describe(const std::string& section, Described& into) {
        into.called = named(section + ".title", into.texts);
        into.named_source = required(section + ".source");
        into.quote = taken(section + ".quote").value_or("");
        into.read_at = taken(section + ".read-at").value_or("");
        if (into.quote.empty() != into.read_at.empty())
            refuse("quote and read-at belong together", section + (into.quote.empty() ? ".read-at" : ".quote"), "",
                   "words of the source, and where they were read", "Give both, or none if no source was read");
    }
    /// Returns the numbers N of sections PREFIX-N that have entries left, rising.
    [[nodiscard]] std::vector<int> numbered(const std::string& prefix, int most) const;
    [[nodiscard]] bool has_section(const std::string& section) const;
    /// Refuses the entries that nobody took.
    void refuse_rest();

  private:
    std::string label_, guide_;
    Problems& problems_;
    std::map<std::string, std::string> entries_;
    std::vector<std::string> known_;
};

/// A folder of data files in the share folder.
struct DataFolder {
    const char *folder, *what;  ///< "schemes", "hazard scheme"
    const char* lists;          ///< "`frana schemes` lists them"
};
inline constexpr DataFolder k_scheme_folder{"schemes", "hazard scheme", "`frana schemes` lists them"};
inline constexpr DataFolder k_friction_folder{"friction", "friction table", "`frana schemes --friction` lists them"};

/// Returns its files, in alphabetical order. Throws Error(environment) if it is missing.
std::vector<std::string> data_files(const std::string& share, const DataFolder& of);
/// Returns their names, without .ini.
std::vector<std::string> data_names(const std::string& share, const DataFolder& of);

/// Whether a key names a data file of one's own, not one of the share folder.
inline bool is_own_file(const std::string& value) {
    return value.ends_with(".ini");
}

/// Returns the file that a key names; none, with a problem, if there is none of this name.
std::optional<std::string> data_file_of(const std::string& value, const std::string& share, const DataFolder& of,
                                        const Place& where, Problems& problems);

}  // namespace frana
