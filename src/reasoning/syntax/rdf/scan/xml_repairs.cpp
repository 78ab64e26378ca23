#include "reasoning/syntax/rdf/scan/xml_repairs.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::rdf {
namespace {

constexpr std::size_t npos = std::string_view::npos;

/// An attribute in its tag: the places of its name, its value, and behind its closing quotation mark.
struct Found {
  std::size_t name = 0;
  std::size_t value = 0;
  std::size_t end = 0;
};

std::optional<Found> find_attribute(std::string_view tag, std::string_view name) {
  const std::size_t at = tag.find(name);
  if (at == npos || at == 0 || xml_space.find(tag[at - 1]) == npos) return std::nullopt;
  const std::size_t equals = tag.find_first_not_of(xml_space, at + name.size());
  if (equals == npos || tag[equals] != '=') return std::nullopt;
  const std::size_t open = tag.find_first_not_of(xml_space, equals + 1);
  if (open == npos || (tag[open] != '"' && tag[open] != '\'')) return std::nullopt;
  const std::size_t close = tag.find(tag[open], open + 1);
  if (close == npos) return std::nullopt;
  return Found{at, open + 1, close + 1};
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

/// Whether a local name is one of OWL's or RDF's own, but of no annotation.
bool is_structural(std::string_view local) {
  constexpr std::array<std::string_view, 5> texts{"comment", "label", "seeAlso", "isDefinedBy", "versionInfo"};
  if (std::ranges::find(texts, local) != texts.end()) return false;
  for (std::uint32_t word = 1; word < static_cast<std::uint32_t>(syntax::Word::count); ++word) {
    const std::string_view iri = syntax::iri_of(static_cast<syntax::Word>(word));
    if (iri.starts_with(syntax::skos_namespace)) continue;
    if (iri.size() > local.size() && iri.ends_with(local) && iri[iri.size() - local.size() - 1] == '#') return true;
  }
  return false;
}

}  // namespace

bool is_xml_name(std::string_view name) {
  return !name.empty() && is_letter(name.front()) && std::ranges::all_of(name, [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '&' || c == ';';
  });
}

std::string_view element_name(std::string_view tag) {
  return tag.substr(1, std::min(tag.find_first_of(" \t\r\n/>"), tag.size()) - 1);
}

std::optional<IdAttribute> id_attribute(std::string_view tag, std::size_t begin) {
  const auto found = find_attribute(tag, "rdf:ID");
  if (!found) return std::nullopt;
  return IdAttribute{
      tag.substr(found->value, found->end - 1 - found->value),
      {begin + found->name, found->value - found->name, std::string("rdf:about=") + tag[found->value - 1] + '#'}};
}

std::string legal_node_id(std::string_view name) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string legal = "illegal.";
  for (const char c : name) {
    legal += digits[static_cast<unsigned char>(c) / 16];
    legal += digits[static_cast<unsigned char>(c) % 16];
  }
  return legal;
}

std::optional<Rewrite> as_xml_literal(std::string_view tag, std::size_t begin, std::string_view rdf) {
  if (tag.find("parseType") != npos || tag.find("resource") != npos || tag.find("nodeID") != npos) return std::nullopt;
  const std::string_view name = element_name(tag);
  if (is_structural(name.substr(name.find(':') + 1))) return std::nullopt;
  const std::string prefix = std::string(rdf) + ':';
  const std::string literal = prefix + "parseType=\"Literal\"";
  const auto datatype = find_attribute(tag, prefix + "datatype");
  if (!datatype) return Rewrite{begin + 1 + name.size(), 0, ' ' + literal};
  if (tag.substr(datatype->name, datatype->end - datatype->name).find('\n') != npos) return std::nullopt;
  return Rewrite{begin + datatype->name, datatype->end - datatype->name, literal};
}

}  // namespace geminga::rdf
