// Describes "why not" in lines for a person, and in one short line.
#include <algorithm>

#include "reasoning/explanation/why_not.hpp"
#include "reasoning/owl/axiom.hpp"
#include "reasoning/owl/left_out.hpp"

namespace geminga::explanation {
namespace {

std::string place(const ExplainedAxiom& axiom) {
  if (axiom.file.empty()) return "";
  return "   [" + axiom.file + (axiom.line == 0 ? "" : ':' + std::to_string(axiom.line)) + ']';
}

std::string names_of(const compiled::Ontology& ontology, const std::vector<taxonomy::ClassNumber>& classes) {
  std::string names;
  for (const taxonomy::ClassNumber number : classes) names += (names.empty() ? "" : ", ") + ontology.short_name(number);
  return names;
}

std::string common_words(const compiled::Ontology& ontology, taxonomy::ClassNumber sub, taxonomy::ClassNumber super,
                         const WhyNot& why_not) {
  const std::string names = names_of(ontology, why_not.common);
  if (ontology.is_subsumed(super, sub)) {
    return "Nearest: " + ontology.short_name(super) + " is subsumed by " + ontology.short_name(sub) +
           ", but not the other way round";
  }
  if (names == ontology.short_name(owl::owl_thing)) return "Nearest: they have nothing in common but " + names;
  return "Nearest: both are " + names;
}

std::string words_of(const Requirement& requirement) {
  std::string line = requirement.is_met ? "  met      " : "  missing  ";
  line += requirement.text;
  return requirement.remark.empty() ? line : line + "   (" + requirement.remark + ")";
}

}  // namespace

std::vector<std::string> describe(const compiled::Ontology& ontology, taxonomy::ClassNumber sub,
                                  taxonomy::ClassNumber super, const WhyNot& why_not) {
  const std::string narrow = ontology.short_name(sub);
  const std::string broad = ontology.short_name(super);
  std::vector<std::string> lines = {common_words(ontology, sub, super, why_not)};
  if (why_not.is_excluded) {
    lines.push_back("Nothing can be " + narrow + " and " + broad + ", because:");
    for (const ExplainedAxiom& axiom : why_not.exclusion) lines.push_back("  " + axiom.text + place(axiom));
  }
  for (const Way& way : why_not.ways) {
    if (!way.is_sufficient) continue;
    lines.push_back("Enough to be " + broad + ":" + place(way.axiom));
    for (const Requirement& requirement : way.requirements) lines.push_back(words_of(requirement));
  }
  if (std::ranges::none_of(why_not.ways, &Way::is_sufficient)) {
    lines.push_back("No axiom says what is enough to be " + broad + ": only what is said to be below it is");
  }
  if (!std::ranges::all_of(why_not.ways, &Way::is_sufficient)) {
    lines.push_back("What every " + broad + " is, too:");
    for (const Way& way : why_not.ways) {
      if (way.is_sufficient) continue;
      for (const Requirement& requirement : way.requirements) lines.push_back(words_of(requirement) + place(way.axiom));
    }
  }
  if (why_not.has_more_ways) lines.push_back("There are more axioms about " + broad + " than are shown");
  if (why_not.may_be_incomplete) {
    lines.push_back(ontology.left_out().empty()
                        ? "Not everything was decided when the ontology was loaded: it might follow after all"
                        : "Axioms were left out when the ontology was loaded: with them it might follow after all");
  }
  return lines;
}

std::string describe_briefly(const compiled::Ontology& ontology, taxonomy::ClassNumber sub, taxonomy::ClassNumber super,
                             const WhyNot& why_not) {
  std::string text = common_words(ontology, sub, super, why_not);
  text.front() = 'n';
  if (why_not.is_excluded) return text + "; nothing can be both";
  const auto way = std::ranges::find_if(why_not.ways, &Way::is_sufficient);
  if (way == why_not.ways.end()) return text;
  std::string missing;
  for (const Requirement& requirement : way->requirements) {
    if (!requirement.is_met) missing += (missing.empty() ? "" : ", ") + requirement.text;
  }
  return text + "; to be " + ontology.short_name(super) + " it lacks " + missing;
}

}  // namespace geminga::explanation
