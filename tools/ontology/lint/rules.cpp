#include "ontology/lint/rules.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "base/assert.hpp"

namespace geminga::ontology {
namespace {

constexpr std::array table{
    Rule{"contradiction", Level::error, "the files contradict themselves"},
    Rule{"unsatisfiable", Level::error, "a class that can have no instance"},
    Rule{"unknown-word", Level::error, "a word that RDF, RDFS, OWL or XSD do not have"},
    Rule{"undeclared", Level::error, "a name that nothing declares although the files declare others of its namespace"},
    Rule{"two-kinds", Level::error, "one name for an object and a data property, or for a class and a datatype"},
    Rule{"cycle", Level::warning, "classes that are told to be below each other, and so are one"},
    Rule{"no-label", Level::warning, "an entity without a label"},
    Rule{"same-label", Level::warning, "one label for several classes or several properties"},
    Rule{"odd-label", Level::warning, "an empty label, or one with blanks at an end or in a row"},
    Rule{"deprecated", Level::warning, "an axiom that uses a deprecated entity"},
    Rule{"unused", Level::warning, "a declared name that no axiom uses"},
    Rule{"no-ontology-name", Level::warning, "a file whose ontology has no name"},
    Rule{"several-roots", Level::info, "more than one class with nothing above it"},
    Rule{"superfluous", Level::info, "an inclusion that follows from nearer ones"},
    Rule{"synonyms", Level::info, "classes that are equivalent"},
    Rule{"no-definition", Level::info, "a class or property without a comment or definition"},
    Rule{"no-domain-or-range", Level::info, "a property of which neither domain nor range is told"},
};

}  // namespace

std::string_view to_string(Level level) {
  return level == Level::error ? "error" : level == Level::warning ? "warning" : "info";
}

std::optional<Level> find_level(std::string_view word) {
  for (const Level level : {Level::error, Level::warning, Level::info}) {
    if (to_string(level) == word) return level;
  }
  return std::nullopt;
}

std::span<const Rule> rules() { return table; }

const Rule* find_rule(std::string_view code) {
  const auto* const found = std::ranges::find(table, code, &Rule::code);
  return found == table.end() ? nullptr : found;
}

void LintFindings::add(std::string_view code, const Entity& entity, std::string words) {
  add(code, entity.file, entity.line, std::move(words));
  found_.back().iri = entity.iri;
}

void LintFindings::add(std::string_view code, std::string file, std::uint32_t line, std::string words) {
  const Rule* const rule = find_rule(code);
  GEMINGA_ASSERT(rule != nullptr);
  found_.push_back({rule, {}, std::move(file), line, std::move(words)});
}

std::vector<LintFinding> LintFindings::take() {
  std::ranges::stable_sort(found_, {}, [](const LintFinding& one) {
    return std::tie(one.file, one.line, one.rule->level, one.rule->code, one.words);
  });
  return std::exchange(found_, {});
}

}  // namespace geminga::ontology
