#include "ontology/alignment/lexicon.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "ontology/alignment/words.hpp"
#include "ontology/entities/entities.hpp"
#include "reasoning/compiled/similar.hpp"
#include "reasoning/owl/annotation.hpp"

namespace geminga::ontology {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

constexpr std::array<std::string_view, 6> naming{"http://www.w3.org/2000/01/rdf-schema#label",
                                                 "http://www.w3.org/2004/02/skos/core#prefLabel",
                                                 "http://www.w3.org/2004/02/skos/core#altLabel",
                                                 "http://www.geneontology.org/formats/oboInOwl#hasExactSynonym",
                                                 "http://www.geneontology.org/formats/oboInOwl#hasRelatedSynonym",
                                                 "http://purl.obolibrary.org/obo/IAO_0000118"};

/// A name that is shortened is worth less than one that a file gives.
constexpr double worth_of_shorter = 0.9;
/// A word is common where so many classes have it, and one class of so many.
constexpr std::size_t least_common = 3;
constexpr std::size_t common_share = 20;

/// Names such as GO_0005575 and MA_0001 are numbers: only labels say what they mean.
bool is_code(const std::vector<std::string>& words) {
  return std::ranges::any_of(words, [](const std::string& word) {
    return word.size() >= 4 && std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
  });
}

bool has_name(const LexiconEntry& entry, const std::vector<std::string>& words) {
  return std::ranges::find(entry.names, words, &EntityName::words) != entry.names.end();
}

void add_name(LexiconEntry& entry, std::string_view name) {
  const bool is_class = entry.kind == TermKind::named_class;
  std::vector<std::string> words = is_class ? words_of_class(name) : words_of_property(name);
  if (words.empty() || is_code(words) || has_name(entry, words)) return;
  entry.names.push_back({.words = std::move(words), .preposition = is_class ? "" : preposition_of(name), .worth = 1});
}

/// `words` without those that `is_said` holds for at either end; all of them where nothing else would be left.
template <typename Predicate>
std::vector<std::string> without_ends(std::span<const std::string> words, const Predicate& is_said) {
  std::span<const std::string> left = words;
  while (!left.empty() && is_said(left.front())) left = left.subspan(1);
  while (!left.empty() && is_said(left.back())) left = left.first(left.size() - 1);
  if (left.empty()) left = words;
  return {left.begin(), left.end()};
}

/// The named classes of a domain or range: itself, or the parts of a union.
void add_classes(const owl::Ontology& source, TermId id, std::vector<TermId>& classes) {
  const owl::Term term = source.term(id);
  if (term.kind == TermKind::named_class) classes.push_back(id);
  if (term.kind != TermKind::object_union_of) return;
  for (const TermId part : term.arguments) {
    if (source.kind(part) == TermKind::named_class) classes.push_back(part);
  }
}

}  // namespace

Lexicon::Lexicon(const rdf::Loaded& loaded) {
  const Entities described(loaded);
  for (const Entity& one : described.all()) {
    if (one.kind <= TermKind::data_property) entities_.push_back({one.kind, one.iri, {}, {}, {}});
  }
  for (std::uint32_t id = 0; id < loaded.source.term_count(); ++id) {
    const TermId term{id};
    const TermKind kind = loaded.source.kind(term);
    if (kind > TermKind::data_property) continue;
    const auto at = std::ranges::lower_bound(entities_, std::pair(std::string(loaded.source.name_of(term)), kind), {},
                                             [](const LexiconEntry& one) { return std::pair(one.iri, one.kind); });
    if (at != entities_.end() && at->iri == loaded.source.name_of(term) && at->kind == kind)
      number_of_.emplace(id, static_cast<std::uint32_t>(at - entities_.begin()));
  }
  add_names(loaded);
  add_neighbours(loaded.source);
  add_shorter_names();
}

void Lexicon::add_names(const rdf::Loaded& loaded) {
  for (LexiconEntry& entry : entities_) add_name(entry, compiled::local_name(entry.iri));
  for (const owl::Annotation& one : loaded.annotations) {
    if (one.of != owl::Annotation::Of::name || !one.is_literal) continue;
    if (std::ranges::find(naming, one.property) == naming.end()) continue;
    const auto [first, last] = std::ranges::equal_range(entities_, one.subject, {}, &LexiconEntry::iri);
    for (LexiconEntry& entry : std::ranges::subrange(first, last)) add_name(entry, one.value);
  }
}

void Lexicon::add_neighbours(const owl::Ontology& source) {
  const auto number = [this](TermId term) {
    const auto found = number_of_.find(static_cast<std::uint32_t>(term));
    return found == number_of_.end() ? entities_.size() : found->second;
  };
  for (std::uint32_t at = 0; at < source.axiom_count(); ++at) {
    const owl::Axiom axiom = source.axiom(at);
    const bool is_inclusion = axiom.kind == AxiomKind::sub_class_of;
    const bool is_domain =
        axiom.kind == AxiomKind::object_property_domain || axiom.kind == AxiomKind::data_property_domain;
    if (!is_inclusion && !is_domain && axiom.kind != AxiomKind::object_property_range) continue;
    const std::size_t subject = number(axiom.arguments[0]);
    std::vector<TermId> classes;
    add_classes(source, axiom.arguments[1], classes);
    for (const TermId one : classes) {
      const std::size_t object = number(one);
      if (subject == entities_.size() || object == entities_.size() || subject == object) continue;
      const auto object_number = static_cast<std::uint32_t>(object);
      if (is_inclusion) entities_[object].below.push_back(static_cast<std::uint32_t>(subject));
      (is_inclusion || is_domain ? entities_[subject].above : entities_[subject].below).push_back(object_number);
    }
  }
}

void Lexicon::add_shorter_names() {
  std::set<std::pair<TermKind, std::vector<std::string>>> given;
  std::map<std::string, std::size_t> classes_with;
  std::size_t classes = 0;
  for (const LexiconEntry& entry : entities_) {
    for (const EntityName& name : entry.names) given.emplace(entry.kind, name.words);
    if (entry.kind != TermKind::named_class || entry.names.empty()) continue;
    ++classes;
    for (const std::string& word : std::set(entry.names[0].words.begin(), entry.names[0].words.end()))
      ++classes_with[word];
  }
  const auto is_common = [&](const std::string& word) {
    const auto found = classes_with.find(word);
    const std::size_t count = found == classes_with.end() ? 0 : found->second;
    return count >= least_common && common_share * count >= classes;
  };
  for (LexiconEntry& entry : entities_) {
    const bool is_class = entry.kind == TermKind::named_class;
    std::set<std::string> around;
    if (!is_class) {
      for (const auto* const neighbours : {&entry.above, &entry.below}) {
        for (const std::uint32_t each : *neighbours) {
          for (const EntityName& name : entities_[each].names) around.insert(name.words.begin(), name.words.end());
        }
      }
    }
    const std::vector<EntityName> names = entry.names;
    for (const EntityName& name : names) {
      // The last word of a class says what it is, and stays.
      const std::span<const std::string> words(name.words);
      std::vector<std::string> shorter =
          is_class ? without_ends(words.first(words.size() - 1), is_common)
                   : without_ends(words, [&around](const std::string& word) { return around.contains(word); });
      if (is_class) shorter.push_back(words.back());
      if (is_class && words.size() == 2 && is_common(words.front())) shorter = {words.back()};
      if (!given.contains({entry.kind, shorter}) && !has_name(entry, shorter))
        entry.names.push_back(
            {.words = std::move(shorter), .preposition = name.preposition, .worth = worth_of_shorter});
    }
  }
}

}  // namespace geminga::ontology
