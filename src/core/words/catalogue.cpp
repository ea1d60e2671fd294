// SPDX-License-Identifier: Apache-2.0
#include "core/words/catalogue.h"

#include <vector>

#include "core/error.h"

namespace frana {
namespace {

constexpr std::uint32_t k_catalogue_magic = 0x950412DE;
constexpr std::uint64_t k_entry_size = 8;  // length and place

[[noreturn]] void refuse_catalogue(const char* what) {
    throw Error(ErrorKind::environment, Problem{what, "catalogue of texts", "", "", "Build the program again"});
}

}  // namespace

Catalogue::Catalogue(std::string_view bytes) : bytes_(bytes) {
    if (number(0) != k_catalogue_magic || number(4) >> 16 != 0) refuse_catalogue("not a compiled catalogue");
    end_ = number(8);
    english_at_ = number(12);
    text_at_ = number(16);
    for (std::uint32_t i = 0; i < end_; ++i) {
        (void)entry(text_at_, i);
        if (i > 0 && entry(english_at_, i - 1) >= entry(english_at_, i)) refuse_catalogue("texts are not sorted");
    }
    if (end_ > 0 && entry(english_at_, 0).empty()) begin_ = 1;
}

/// msgfmt writes the lowest byte first, on every machine.
std::uint32_t Catalogue::number(std::uint64_t at) const {
    if (at + 4 > bytes_.size()) refuse_catalogue("ends early");
    std::uint32_t value = 0;
    for (std::uint64_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes_[at + i]);
    return value;
}

std::string_view Catalogue::entry(std::uint32_t table, std::uint32_t index) const {
    const std::uint64_t at = table + k_entry_size * index, length = number(at), begin = number(at + 4);
    if (begin + length > bytes_.size()) refuse_catalogue("ends early");
    return bytes_.substr(begin, length);
}

std::optional<std::string_view> Catalogue::find(std::string_view english) const {
    std::uint32_t begin = begin_, end = end_;
    while (begin < end) {
        const std::uint32_t middle = begin + (end - begin) / 2;
        const int order = entry(english_at_, middle).compare(english);
        if (order == 0) return entry(text_at_, middle);
        (order < 0 ? begin : end) = order < 0 ? middle + 1 : middle;
    }
    return std::nullopt;
}

const Catalogue& catalogue_of(Language language) {
    static const auto k_catalogues = [] {
        std::vector<Catalogue> all(languages().size());
        for (const EmbeddedCatalogue& one : embedded_catalogues())
            if (const auto of = language_of_code(one.code)) all[static_cast<std::size_t>(*of)] = Catalogue(one.bytes);
        return all;
    }();
    return k_catalogues.at(static_cast<std::size_t>(language));
}

}  // namespace frana
