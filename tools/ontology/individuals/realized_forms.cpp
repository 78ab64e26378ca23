#include "ontology/individuals/realized_forms.hpp"

#include <algorithm>
#include <boost/json.hpp>

#include "base/text.hpp"
#include "ontology/command/words.hpp"
#include "reasoning/owl/print.hpp"

namespace geminga::ontology {

RealizedForms::RealizedForms(const ClassifiedFiles& classified, const realization::Realization& realization, bool all)
    : classified_(classified),
      realization_(realization),
      classes_(class_hierarchy(classified.loaded.source, classified.classification)),
      all_(all) {}

/// Representatives. That of owl:Thing stands alone, or last among all where other classes are equivalent to it.
std::vector<std::uint32_t> RealizedForms::types_of(std::uint32_t individual, bool all) const {
  const auto& types = realization_.type_sets[realization_.types[individual]];
  const auto chosen = all ? types : realization::most_specific(classified_.classification, types);
  std::vector<std::uint32_t> found;
  for (const taxonomy::ClassNumber of : chosen) found.push_back(static_cast<std::uint32_t>(of));
  const std::uint32_t top = classes_.representative[classes_.top];
  if (found.empty() || (all && classes_.members[top].size() > 1)) found.push_back(top);
  return found;
}

/// The individuals that are the same, in the order of the first.
std::vector<std::vector<std::uint32_t>> RealizedForms::things() const {
  std::vector<std::vector<std::uint32_t>> members(realization_.individuals.size());
  for (std::uint32_t at = 0; at < members.size(); ++at) members[realization_.representative[at]].push_back(at);
  std::erase_if(members, [](const auto& names) { return names.empty(); });
  return members;
}

bool RealizedForms::write_types(const Sink& sink) const {
  const auto short_name = short_names(classified_.loaded.source);
  for (const auto& names : things()) {
    std::vector<std::string> subjects;
    for (const std::uint32_t at : names) subjects.push_back(short_name(iri(realization_.individuals[at])));
    std::vector<std::string> types;
    for (const std::uint32_t of : types_of(names.front(), all_)) {
      std::vector<std::string> equal;
      for (const std::uint32_t member : classes_.members[of]) equal.push_back(short_name(classes_.iris[member]));
      types.push_back(base::joined(equal, " = "));
    }
    if (!sink(base::joined(subjects, " = ") + ": " + base::joined(types, ", ") + '\n')) return false;
  }
  return true;
}

bool RealizedForms::write_closure(const Sink& sink) const {
  for (std::uint32_t at = 0; at < realization_.individuals.size(); ++at) {
    std::vector<std::string_view> types;
    for (const std::uint32_t of : types_of(at, true)) {
      for (const std::uint32_t member : classes_.members[of]) {
        if (member != classes_.top) types.push_back(classes_.iris[member]);
      }
    }
    std::ranges::sort(types);
    types.erase(std::ranges::unique(types).begin(), types.end());
    const std::string subject(iri(realization_.individuals[at]));
    for (const std::string_view type : types) {
      if (!sink(subject + '\t' + std::string(type) + '\n')) return false;
    }
  }
  return true;
}

bool RealizedForms::write_facts(const Sink& sink) const {
  const owl::Ontology& source = classified_.loaded.source;
  const auto short_name = short_names(source);
  for (const realization::Fact& fact : realization_.facts) {
    if (!sink(short_name(iri(fact.subject)) + ' ' + short_name(iri(fact.property)) + ' ' +
              owl::print(source, fact.object, short_name) + '\n'))
      return false;
  }
  return true;
}

bool RealizedForms::write_fact_closure(const Sink& sink) const {
  const owl::Ontology& source = classified_.loaded.source;
  const auto whole = [](std::string_view name) { return std::string(name); };
  std::vector<std::string> lines;
  for (const realization::Fact& fact : realization_.facts) {
    lines.push_back(std::string(iri(fact.subject)) + '\t' + std::string(iri(fact.property)) + '\t' +
                    owl::print(source, fact.object, whole) + '\n');
  }
  std::ranges::sort(lines);
  return std::ranges::all_of(lines, [&](const std::string& line) { return sink(line); });
}

boost::json::array RealizedForms::json_things() const {
  boost::json::array things_array;
  for (const auto& names : things()) {
    boost::json::array subjects;
    for (const std::uint32_t at : names) subjects.emplace_back(iri(realization_.individuals[at]));
    boost::json::array types;
    for (const std::uint32_t of : types_of(names.front(), all_)) {
      for (const std::uint32_t member : classes_.members[of]) types.emplace_back(classes_.iris[member]);
    }
    things_array.push_back(boost::json::object{{"individuals", std::move(subjects)}, {"types", std::move(types)}});
  }
  return things_array;
}

bool RealizedForms::write_json_facts(const Sink& sink) const {
  const owl::Ontology& source = classified_.loaded.source;
  std::string_view separator = "[";
  for (const realization::Fact& fact : realization_.facts) {
    boost::json::object entry{{"subject", iri(fact.subject)}, {"property", iri(fact.property)}};
    const owl::Term object = source.term(fact.object);
    if (object.kind == owl::TermKind::literal) {
      entry["value"] = source.name(object.name);
      entry["datatype"] = iri(object.arguments[0]);
      if (object.arguments.size() > 1) entry["language"] = iri(object.arguments[1]);
    } else {
      entry["object"] = iri(fact.object);
    }
    if (!sink(std::string(separator) + json_text(entry))) return false;
    separator = ",";
  }
  return sink(realization_.facts.empty() ? "[]" : "]");
}

}  // namespace geminga::ontology
