// Namespaces are counted by the names in them; the fullest one chooses its word first.
#include "reasoning/owl/prefixes/prefixes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <unordered_map>

#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/print.hpp"

namespace geminga::owl {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> usual{
    {{"owl", "http://www.w3.org/2002/07/owl#"},
     {"rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#"},
     {"rdfs", "http://www.w3.org/2000/01/rdf-schema#"},
     {"xsd", "http://www.w3.org/2001/XMLSchema#"}}};
/// Words before the colon of an IRI, which a reader would take for one.
constexpr std::array<std::string_view, 6> schemes{"file", "ftp", "http", "https", "mailto", "urn"};
constexpr std::array<std::string_view, 9> endings{".owl", ".rdf", ".ttl",  ".xml", ".omn",
                                                  ".ofn", ".owx", ".rdfs", ".obo"};
/// Names that a program made, not a file.
constexpr std::string_view made_names = "urn:geminga:";

/// A namespace and how many names it has.
using Namespace = std::pair<std::string_view, std::size_t>;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_word(std::string_view text) {
  return !text.empty() && is_letter(text.front()) && std::ranges::all_of(text, [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
}

/// The namespaces of classes, properties and individuals that `is_known` does not know, the fullest ones first.
template <typename IsKnown>
std::vector<Namespace> namespaces_in(const Ontology& source, const IsKnown& is_known) {
  std::unordered_map<std::string_view, std::size_t> names;
  for (std::size_t number = 0; number < source.term_count(); ++number) {
    const TermId term{static_cast<std::uint32_t>(number)};
    const TermKind kind = source.kind(term);
    if (kind != TermKind::named_class && kind != TermKind::object_property && kind != TermKind::data_property &&
        kind != TermKind::individual)
      continue;
    const std::string_view iri = source.name_of(term);
    const std::size_t end = iri.find_last_of("#/");
    if (end == std::string_view::npos || iri.starts_with(made_names) || !is_plain_local_name(iri.substr(end + 1)))
      continue;
    ++names[iri.substr(0, end + 1)];
  }
  std::erase_if(names, [&](const Namespace& one) { return one.second < min_names_of_prefix || is_known(one.first); });
  std::vector<Namespace> found(names.begin(), names.end());
  std::ranges::sort(found, [](const Namespace& a, const Namespace& b) {
    return a.second != b.second ? a.second > b.second : a.first < b.first;
  });
  if (found.size() > max_found_prefixes) found.resize(max_found_prefixes);
  return found;
}

/// The ontology IRI, if the files have one alone.
std::optional<std::string_view> only_ontology_iri(const Ontology& source) {
  std::optional<std::string_view> only;
  for (const LoadedFile& file : source.files()) {
    if (only && *only != file.ontology_iri) return std::nullopt;
    only = file.ontology_iri;
  }
  return only && !only->empty() ? only : std::nullopt;
}

bool is_namespace_of(std::string_view space, std::string_view ontology_iri) {
  return space == ontology_iri ||
         (space.starts_with(ontology_iri) && space.size() == ontology_iri.size() + 1);  // it ends in # or /
}

}  // namespace

std::string word_of_namespace(std::string_view iri) {
  while (!iri.empty()) {
    iri = iri.substr(0, iri.find_last_not_of("#/") + 1);
    const std::size_t begin = iri.find_last_of("#/") + 1;  // 0 if there is none
    std::string_view piece = iri.substr(begin);
    for (const std::string_view ending : endings) {
      if (piece.ends_with(ending)) piece.remove_suffix(ending.size());
    }
    const bool is_host = iri.substr(0, begin).ends_with("//");
    if (is_host) {
      if (piece.starts_with("www.")) piece.remove_prefix(4);
      piece = piece.substr(0, piece.find('.'));
    }
    if (is_word(piece)) return std::string(piece);
    if (is_host) break;
    iri = iri.substr(0, begin);
  }
  return "ns";
}

Prefixes::Prefixes(const Ontology& source) {
  std::set<std::string, std::less<>> words(schemes.begin(), schemes.end());
  std::set<std::string, std::less<>> spaces;
  const auto add = [&](std::string_view word, std::string_view iri) {
    all_.emplace_back(word, iri);
    words.emplace(word);
    spaces.emplace(iri);
  };
  for (const Ontology::Prefix& prefix : source.prefixes()) add(source.name(prefix.prefix), source.name(prefix.iri));
  for (const auto& [word, iri] : usual) {
    if (!words.contains(word)) add(word, iri);
  }
  const auto own = only_ontology_iri(source);
  for (const auto& [space, count] : namespaces_in(source, [&](std::string_view iri) { return spaces.contains(iri); })) {
    if (own && is_namespace_of(space, *own) && !words.contains("")) {
      add("", space);
      continue;
    }
    std::string word = word_of_namespace(space);
    const std::string first = word;
    for (std::size_t number = 2; words.contains(word); ++number) word = first + std::to_string(number);
    add(word, space);
  }
  std::ranges::sort(all_);
  views_.assign(all_.begin(), all_.end());
}

std::string Prefixes::short_name(std::string_view iri) const { return shorten(iri, views_); }

}  // namespace geminga::owl
