// "Why not" in lines for a person.
#include <algorithm>

#include "el/axiom.hpp"
#include "reasoner/why_not.hpp"

namespace geminga::reasoner {
namespace {

std::string place(const ExplainedAxiom& axiom) {
  if (axiom.file.empty()) return "";
  return "   [" + axiom.file + (axiom.line == 0 ? "" : ':' + std::to_string(axiom.line)) + ']';
}

std::string common_words(const el::Ontology& ontology, const WhyNot& why_not) {
  std::string names;
  for (const el::ClassNumber number : why_not.common) {
    names += (names.empty() ? "" : ", ") + ontology.short_name(number);
  }
  if (names == ontology.short_name(el::owl_thing)) return "Nearest: they have nothing in common but " + names;
  return "Nearest: both are " + names;
}

void describe_way(const std::string& super, const Way& way, std::vector<std::string>& lines) {
  const std::string what = way.is_sufficient ? "Enough to be " + super : "Every " + super + " has to be, too";
  lines.push_back(what + ":" + place(way.axiom));
  for (const Requirement& requirement : way.requirements) {
    std::string line = requirement.is_met ? "  met      " : "  missing  ";
    line += requirement.text;
    if (!requirement.remark.empty()) line += "   (" + requirement.remark + ")";
    lines.push_back(std::move(line));
  }
}

}  // namespace

std::vector<std::string> describe(const el::Ontology& ontology, el::ClassNumber sub, el::ClassNumber super,
                                  const WhyNot& why_not) {
  const std::string narrow = ontology.short_name(sub);
  const std::string broad = ontology.short_name(super);
  std::vector<std::string> lines = {common_words(ontology, why_not)};
  if (why_not.is_excluded) {
    lines.push_back("Nothing can be " + narrow + " and " + broad + ", because:");
    for (const ExplainedAxiom& axiom : why_not.exclusion) lines.push_back("  " + axiom.text + place(axiom));
  }
  if (std::ranges::none_of(why_not.ways, &Way::is_sufficient)) {
    lines.push_back("No axiom says what is enough to be " + broad + ": only what is told to be below it is, and " +
                    narrow + " is not");
  }
  for (const Way& way : why_not.ways) describe_way(broad, way, lines);
  if (why_not.has_more_ways) lines.push_back("There are more axioms about " + broad + " than are shown");
  if (why_not.may_be_incomplete) {
    lines.push_back("Axioms were left out when the ontology was loaded: with them it might follow after all");
  }
  return lines;
}

}  // namespace geminga::reasoner
