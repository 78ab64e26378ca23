#include "discovery/announcement/term_table.hpp"

#include <algorithm>

#include "discovery/announcement/varint.hpp"

namespace geminga::announcement {
SplitIri split_iri(std::string_view iri) {
  const auto last = iri.find_last_of("#/");
  const auto begin = last == std::string_view::npos ? 0 : last + 1;
  return {iri.substr(0, begin), iri.substr(begin)};
}

std::size_t framed_bytes(std::size_t tag_bytes, std::size_t content_bytes) {
  return tag_bytes + varint_bytes(content_bytes) + content_bytes;
}

std::uint32_t TermTable::name_space_number(std::string_view name_space) {
  if (name_space.empty()) return 0;
  const auto known = std::ranges::find(name_spaces_, name_space);
  const auto number = static_cast<std::uint32_t>(known - name_spaces_.begin()) + 1;
  if (known == name_spaces_.end()) {
    bytes_ += framed_bytes(2, name_space.size());
    name_spaces_.emplace_back(name_space);
  }
  return number;
}

std::uint32_t TermTable::number(std::string_view iri) {
  if (iri.empty()) return 0;
  const auto [name_space, local] = split_iri(iri);
  const auto space = name_space_number(name_space);
  const auto known =
      std::ranges::find_if(terms_, [&](const Term& term) { return term.name_space == space && term.local == local; });
  const auto number = static_cast<std::uint32_t>(known - terms_.begin()) + 1;
  if (known == terms_.end()) {
    const auto content =
        (space == 0 ? 0 : 1 + varint_bytes(space)) + (local.empty() ? 0 : framed_bytes(1, local.size()));
    bytes_ += framed_bytes(2, content);
    terms_.push_back({space, std::string(local)});
  }
  return number;
}

void TermTable::go_back(const Mark& mark) {
  name_spaces_.resize(mark.name_spaces);
  terms_.resize(mark.terms);
  bytes_ = mark.bytes;
}

}  // namespace geminga::announcement
