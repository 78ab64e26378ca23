// Tables of the entities of an ontology by kind and IRI, and by kind and local name.
#include "reasoning/compiled/entity_names.hpp"

#include <algorithm>

#include "base/edit_distance.hpp"
#include "base/sorted.hpp"
#include "base/text.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/compiled/similar.hpp"
#include "reasoning/owl/datatypes.hpp"

namespace geminga::compiled {
namespace {

constexpr std::string_view xsd = "http://www.w3.org/2001/XMLSchema#";
constexpr std::string_view rdfs_literal = "http://www.w3.org/2000/01/rdf-schema#Literal";

bool is_of_owl(owl::TermKind kind, std::string_view iri) {
  switch (kind) {
    case owl::TermKind::object_property:
      return iri == "http://www.w3.org/2002/07/owl#topObjectProperty" ||
             iri == "http://www.w3.org/2002/07/owl#bottomObjectProperty";
    case owl::TermKind::data_property:
      return iri == "http://www.w3.org/2002/07/owl#topDataProperty" ||
             iri == "http://www.w3.org/2002/07/owl#bottomDataProperty";
    case owl::TermKind::datatype:
      return iri == rdfs_literal || owl::Datatype::find(iri).has_value();
    default:
      return false;
  }
}

std::string_view word_of(owl::TermKind kind) {
  switch (kind) {
    case owl::TermKind::named_class:
      return "class";
    case owl::TermKind::object_property:
      return "object property";
    case owl::TermKind::data_property:
      return "data property";
    case owl::TermKind::individual:
      return "individual";
    default:
      return "datatype";
  }
}

}  // namespace

std::string_view end_of_iri(std::string_view iri) {
  const std::size_t end = iri.find_last_of("#/");
  return end == std::string_view::npos ? iri : iri.substr(end + 1);
}

std::vector<std::uint32_t> classes_with_local_name(const Ontology& ontology, std::string_view name) {
  std::vector<std::uint32_t> found;
  if (name.find_first_of(":/# ") != std::string_view::npos) return found;
  for (std::uint32_t number = 0, all = ontology.class_count(); number < all; ++number) {
    if (end_of_iri(ontology.iri(taxonomy::ClassNumber{number})) == name) found.push_back(number);
  }
  return found;
}

EntityNames::EntityNames(const Ontology& ontology) : ontology_(ontology) {
  const taxonomy::ClassifiedView& view = ontology.axioms();
  for (std::uint32_t term = 0; term < view.term_count(); ++term) {
    const owl::TermKind kind = view.kind_of_term(term);
    const bool is_named = kind == owl::TermKind::object_property || kind == owl::TermKind::data_property ||
                          kind == owl::TermKind::individual || kind == owl::TermKind::datatype;
    if (is_named) entities_.emplace_back(kind, view.name_of_term(term));
  }
  for (std::uint32_t number = 0; number < view.class_count(); ++number) {
    entities_.emplace_back(owl::TermKind::named_class, view.class_iri(number));
  }
  base::sort_unique(entities_);
  for (const auto& [kind, iri] : entities_) local_names_.emplace_back(kind, end_of_iri(iri), iri);
  std::ranges::sort(local_names_);
}

bool EntityNames::has(owl::TermKind kind, std::string_view iri) const {
  return std::ranges::binary_search(entities_, Entity(kind, iri)) || is_of_owl(kind, iri);
}

std::vector<std::string> EntityNames::candidates(owl::TermKind kind, std::string_view name) const {
  std::vector<std::string> found;
  const auto add = [&](std::string iri) {
    if (has(kind, iri)) found.push_back(std::move(iri));
  };
  const std::size_t colon = name.find(':');
  const std::string_view word = colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
  const std::string_view local = colon == std::string_view::npos ? name : name.substr(colon + 1);
  for (auto prefix =
           std::ranges::lower_bound(ontology_.prefixes(), word, {}, [](const auto& pair) { return pair.first; });
       prefix != ontology_.prefixes().end() && prefix->first == word; ++prefix) {
    add(std::string(prefix->second) + std::string(local));
  }
  if (found.empty() && colon != std::string_view::npos) add(std::string(name));
  if (found.empty() && kind == owl::TermKind::datatype && colon == std::string_view::npos)
    add(std::string(xsd) += name);
  return found;
}

std::vector<std::string> EntityNames::with_local_name(owl::TermKind kind, std::string_view name) const {
  std::vector<std::string> found;
  const auto key = [](const auto& entry) { return std::pair(std::get<0>(entry), std::get<1>(entry)); };
  const auto range = std::ranges::equal_range(local_names_, std::pair(kind, name), {}, key);
  for (const auto& entry : range) found.emplace_back(std::get<2>(entry));
  return found;
}

std::vector<std::string> EntityNames::similar_to(owl::TermKind kind, std::string_view name) const {
  if (kind == owl::TermKind::named_class) return find_similar(ontology_, name, {.classes = max_compared_classes});
  const std::string_view local = local_name(name);
  const std::size_t slips = base::tolerated_slips(local);
  // If there are too many, the nearest in the alphabet are taken.
  const auto all =
      std::ranges::equal_range(local_names_, kind, {}, [](const auto& entry) { return std::get<0>(entry); });
  const auto place = std::ranges::lower_bound(all, local, {}, [](const auto& entry) { return std::get<1>(entry); });
  constexpr std::ptrdiff_t around = max_compared_classes / 2;
  std::vector<std::pair<std::size_t, std::string>> found;
  for (auto entry = place - std::min(around, place - all.begin()); entry != place + std::min(around, all.end() - place);
       ++entry) {
    const std::size_t distance = base::edit_distance(local, std::get<1>(*entry), slips);
    if (distance <= slips) found.emplace_back(distance, ontology_.short_name(std::get<2>(*entry)));
  }
  std::ranges::sort(found);
  std::vector<std::string> names;
  for (auto& [distance, similar] : found) {
    if (names.size() == SimilarLimits{}.names) break;
    names.push_back(std::move(similar));
  }
  return names;
}

std::expected<std::string, std::string> EntityNames::find(owl::TermKind kind, std::string_view name) const {
  const std::string shown = base::printable(name);
  if (name.size() > 2 && name.front() == '<' && name.back() == '>') {
    std::string iri(name.substr(1, name.size() - 2));
    if (has(kind, iri)) return iri;
    return std::unexpected("no " + std::string(word_of(kind)) + " has the IRI " + shown +
                           did_you_mean(similar_to(kind, iri)));
  }
  std::vector<std::string> found;
  if (kind == owl::TermKind::named_class) {
    // This looks at labels and local names, too, and gives the same errors as for names outside of expressions.
    const auto number = ontology_.find(name);
    if (number) return std::string(ontology_.iri(*number));
    if (number.error().kind == NameError::Kind::ambiguous) return std::unexpected(number.error().text);
    found = candidates(kind, name);  // the usual prefixes
    if (found.empty()) return std::unexpected(number.error().text + did_you_mean(similar_to(kind, name)));
  } else {
    found = candidates(kind, name);
    if (found.empty()) found = with_local_name(kind, name);
  }
  base::sort_unique(found);
  if (found.size() == 1) return std::move(found.front());
  if (found.empty())
    return std::unexpected("no " + std::string(word_of(kind)) + " is '" + shown + "'" +
                           did_you_mean(similar_to(kind, name)));
  for (std::string& iri : found) iri = ontology_.short_name(std::string_view(iri));
  return std::unexpected("'" + shown + "' may be " + alternatives(found) + ": say which");
}

}  // namespace geminga::compiled
