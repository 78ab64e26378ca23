#include "reasoning/syntax/writing/names.hpp"

#include <algorithm>

#include "base/sorted.hpp"
#include "base/text.hpp"
#include "reasoning/owl/print.hpp"

namespace geminga::writing {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_plain(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.'; }

bool is_prefix(std::string_view prefix) {
  return prefix.empty() || (is_letter(prefix.front()) && prefix.back() != '.' && std::ranges::all_of(prefix, is_plain));
}

}  // namespace

bool is_writable(std::string_view iri) {
  return !iri.empty() && iri.find_first_of(" <>\"{}|\\^`") == std::string_view::npos &&
         !base::has_control_character(iri);
}

std::string unwritable(std::string_view iri) {
  return "the name " + base::printable(iri, 100) +
         " has a character that no IRI may have: write triples, or mend the name";
}

Names::Names(const owl::Ontology& source) {
  for (const owl::Ontology::Prefix& one : source.prefixes()) {
    const Prefix prefix(source.name(one.prefix), source.name(one.iri));
    if (is_prefix(prefix.first) && is_writable(prefix.second)) prefixes_.push_back(prefix);
  }
  base::sort_unique(prefixes_);
  // A prefix of two IRIs means neither.
  std::vector<Prefix> single;
  for (std::size_t at = 0; at < prefixes_.size(); ++at) {
    const bool is_shared = (at > 0 && prefixes_[at - 1].first == prefixes_[at].first) ||
                           (at + 1 < prefixes_.size() && prefixes_[at + 1].first == prefixes_[at].first);
    if (!is_shared) single.push_back(prefixes_[at]);
  }
  prefixes_ = std::move(single);
}

std::string Names::written(std::string_view iri) const {
  std::string found = owl::shorten(iri, prefixes_);
  // Letters beyond ASCII differ between the grammars of local names.
  const bool is_short = !found.starts_with('<') && std::ranges::all_of(found.substr(found.find(':') + 1), is_plain);
  return is_short || found.starts_with('<') ? found : '<' + std::string(iri) + '>';
}

std::string Names::blank(std::string_view name) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  if (name.starts_with("_:")) name.remove_prefix(2);
  std::string label = "_:b";
  for (const char c : name) {
    if (is_letter(c) || (c >= '0' && c <= '9')) {
      label += c;
    } else {
      const auto octet = static_cast<unsigned char>(c);
      label.append(1, '_').append(1, digits[octet >> 4U]).append(1, digits[octet & 15U]);
    }
  }
  return label;
}

}  // namespace geminga::writing
