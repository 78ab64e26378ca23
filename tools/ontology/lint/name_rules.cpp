// The rules about names and annotations, one function each.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/text.hpp"
#include "ontology/findings/axioms.hpp"
#include "ontology/findings/doubtful_names.hpp"
#include "ontology/lint/rules.hpp"
#include "reasoning/compiled/similar.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {
namespace {

using owl::TermKind;

std::string in_quotes(std::string_view label) { return '"' + base::printable(label, 200) + '"'; }

void check_doubtful(const rdf::Loaded& loaded, LintFindings& findings) {
  const NameFindings names = find_doubtful_names(loaded);
  for (const DoubtfulName& one : names.unknown_words)
    findings.add(
        "unknown-word", one.file, one.line,
        base::printable(one.name, 400) + " is no word of its vocabulary" + compiled::did_you_mean(one.similar));
  for (const DoubtfulName& one : names.undeclared)
    findings.add("undeclared", one.file, one.line,
                 std::string(one.kind) + ' ' + base::printable(one.name, 400) + " is declared nowhere" +
                     compiled::did_you_mean(one.similar));
}

void check_kinds(const Entities& entities, LintFindings& findings) {
  const std::vector<Entity>& all = entities.all();
  const auto clash = [](TermKind one, TermKind other) {
    return (one == TermKind::object_property && other == TermKind::data_property) ||
           (one == TermKind::named_class && other == TermKind::datatype);
  };
  // Kinds of one IRI stand side by side, in ascending order.
  for (std::size_t at = 0; at < all.size(); ++at) {
    for (std::size_t other = at + 1; other < all.size() && all[other].iri == all[at].iri; ++other) {
      if (!clash(all[at].kind, all[other].kind)) continue;
      findings.add("two-kinds", all[other],
                   all[other].short_name + " is " + std::string(word_of(all[at].kind)) + " and " +
                       std::string(word_of(all[other].kind)));
    }
  }
}

void check_labels(const Entities& entities, LintFindings& findings) {
  // A class and a property may share a label.
  std::map<std::tuple<bool, std::string, std::string>, std::vector<const Entity*>> by_label;
  for (const Entity& entity : entities.all()) {
    if (entity.labels.empty())
      findings.add("no-label", entity, std::string(word_of(entity.kind)) + ' ' + entity.short_name + " has no label");
    for (const owl::Annotation* label : entity.labels) {
      const std::string_view text = label->value;
      if (text.empty() || base::trimmed(text) != text || text.contains("  "))
        findings.add("odd-label", entity,
                     "the label " + in_quotes(text) + " of " + entity.short_name +
                         (text.empty() ? " is empty" : " has blanks too many"));
      auto& same = by_label[{entity.kind == TermKind::named_class, std::string(text), label->language}];
      if (same.empty() || same.back()->iri != entity.iri) same.push_back(&entity);
    }
  }
  for (const auto& [key, same] : by_label) {
    for (std::size_t at = 1; at < same.size(); ++at)
      findings.add("same-label", *same[at],
                   "the label " + in_quotes(std::get<1>(key)) + " of " + same[at]->short_name + " is that of " +
                       same.front()->short_name + ", too");
  }
}

void check_use(const rdf::Loaded& loaded, const Entities& entities, LintFindings& findings) {
  for (const Entity& entity : entities.all()) {
    const bool is_of_annotations = entity.kind == TermKind::annotation_property;
    if (!entity.is_used && !is_of_annotations && !entity.is_deprecated)
      findings.add("unused", entity,
                   std::string(word_of(entity.kind)) + ' ' + entity.short_name + " is declared, and no axiom uses it");
    if (!entity.has_definition && !is_of_annotations && !entity.is_deprecated)
      findings.add("no-definition", entity,
                   std::string(word_of(entity.kind)) + ' ' + entity.short_name + " has no comment or definition");
  }
  const owl::Ontology& source = loaded.source;
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    const owl::Axiom axiom = source.axiom(number);
    if (axiom.kind == owl::AxiomKind::declaration) continue;
    const Entity* subject = entities.find(axiom.arguments[0]);
    if (subject != nullptr && subject->is_deprecated) continue;  // what is said of it stays with it
    for (const owl::TermId term : owl::terms_in(source, axiom.arguments)) {
      const Entity* entity = entities.find(term);
      if (entity == nullptr || !entity->is_deprecated) continue;
      findings.add("deprecated", source.files()[static_cast<std::size_t>(axiom.file)].path, axiom.line,
                   entity->short_name + " is deprecated, and an axiom uses it");
    }
  }
}

void check_domains(const rdf::Loaded& loaded, const Entities& entities, LintFindings& findings) {
  std::set<std::string_view> told;
  for (std::uint32_t number = 0; number < loaded.source.axiom_count(); ++number) {
    const owl::Axiom axiom = loaded.source.axiom(number);
    using Kind = owl::AxiomKind;
    // A property with another above it has the domain and range of that one.
    for (const Kind kind : {Kind::object_property_domain, Kind::object_property_range, Kind::data_property_domain,
                            Kind::data_property_range, Kind::sub_object_property_of, Kind::sub_data_property_of,
                            Kind::inverse_object_properties, Kind::equivalent_object_properties}) {
      if (axiom.kind != kind) continue;
      for (const owl::TermId term : axiom.arguments) {
        if (loaded.source.kind(term) <= TermKind::data_property) told.insert(loaded.source.name_of(term));
      }
    }
  }
  for (const Entity& entity : entities.all()) {
    const bool is_property = entity.kind == TermKind::object_property || entity.kind == TermKind::data_property;
    if (is_property && !entity.is_deprecated && !told.contains(entity.iri))
      findings.add("no-domain-or-range", entity, entity.short_name + " has neither a domain nor a range");
  }
}

void check_heads(const rdf::Loaded& loaded, LintFindings& findings) {
  for (const owl::LoadedFile& file : loaded.source.files()) {
    if (file.ontology_iri.empty())
      findings.add("no-ontology-name", file.path, 1, "the ontology of this file has no name: nobody can import it");
  }
}

}  // namespace

void check_names(const rdf::Loaded& loaded, const Entities& entities, LintFindings& findings) {
  check_doubtful(loaded, findings);
  check_kinds(entities, findings);
  check_labels(entities, findings);
  check_use(loaded, entities, findings);
  check_domains(loaded, entities, findings);
  check_heads(loaded, findings);
}

}  // namespace geminga::ontology
