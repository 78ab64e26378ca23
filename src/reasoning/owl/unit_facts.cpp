#include "reasoning/owl/unit_facts.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "reasoning/owl/loaded_file.hpp"

namespace geminga::owl {
namespace {

struct Statement {
  std::string_view subject;
  UnitFact fact;
  UnitPlace place;
  friend auto operator<=>(const Statement&, const Statement&) = default;
};

/// Adds the statements that are axioms. All syntaxes but RDF have facts of individuals there.
void add_axioms(const Ontology& source, std::vector<Statement>& statements) {
  for (std::size_t number = 0; number < source.axiom_count(); ++number) {
    const Axiom axiom = source.axiom(number);
    const bool is_type = axiom.kind == AxiomKind::class_assertion;
    const bool is_fact =
        axiom.kind == AxiomKind::object_property_assertion || axiom.kind == AxiomKind::data_property_assertion;
    if (!is_type && !is_fact) continue;
    const TermId subject = axiom.arguments[1];
    const TermKind kind = source.kind(axiom.arguments[0]);
    const bool is_entity =
        kind == TermKind::named_class || kind == TermKind::object_property || kind == TermKind::data_property;
    if (!is_entity || source.kind(subject) != TermKind::individual) continue;
    const std::string_view said = source.name_of(axiom.arguments[0]);
    UnitFact fact{is_type && is_unit_class(said) ? UnitWord::type : is_type ? UnitWord::none : unit_word(said), said};
    if (fact.word == UnitWord::none) continue;
    if (is_fact) fact.value = source.name_of(axiom.arguments[2]);
    if (is_fact && source.kind(axiom.arguments[2]) == TermKind::anonymous_individual) continue;
    const bool is_too_long =
        source.name_of(subject).size() > max_unit_text_octets || fact.value.size() > max_unit_text_octets;
    if (is_too_long) fact = {UnitWord::too_long, {}};
    statements.push_back({is_too_long ? std::string_view() : source.name_of(subject),
                          fact,
                          {source.files()[static_cast<std::size_t>(axiom.file)].path, axiom.line, axiom.file}});
  }
}

}  // namespace

std::span<const UnitFact> UnitSubject::all(UnitWord word) const {
  const auto found = std::ranges::equal_range(facts, word, {}, &UnitFact::word);
  return {found.begin(), found.end()};
}

std::optional<double> unit_number(std::string_view lexical) {
  if (lexical.starts_with('+')) lexical.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(lexical.data(), lexical.data() + lexical.size(), value);
  const bool is_whole = error == std::errc() && end == lexical.data() + lexical.size();
  return is_whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::expected<std::optional<double>, std::string_view> unit_number(const UnitSubject& subject, UnitWord word) {
  std::optional<double> value;
  for (const UnitFact& fact : subject.all(word)) {
    const auto number = unit_number(fact.value);
    if (!number) return std::unexpected("a unit with a factor, offset or exponent that is no finite number");
    if (value && *value != *number) return std::unexpected("a unit of which two different things are said");
    value = number;
  }
  return value;
}

UnitReading sound(const UnitMeasure& measure) {
  if (!std::isnormal(measure.factor) || measure.factor < 0) {
    return std::unexpected("a unit whose factor is not positive, or too large or too small");
  }
  if (!std::isfinite(measure.offset)) return std::unexpected("a unit whose offset is too large");
  return measure;
}

std::optional<std::vector<UnitSubject>> unit_subjects(const Ontology& source) {
  if (source.unit_statements().size() > max_unit_statements) return std::nullopt;
  std::vector<Statement> statements;
  for (const Ontology::UnitStatement& one : source.unit_statements()) {
    statements.push_back({source.name(one.subject),
                          {one.word, source.name(one.value)},
                          {source.files()[static_cast<std::size_t>(one.file)].path, one.line, one.file}});
  }
  add_axioms(source, statements);
  std::ranges::sort(statements);
  std::vector<UnitSubject> subjects;
  std::size_t count = 0;
  for (const Statement& one : statements) {
    if (subjects.empty() || subjects.back().iri != one.subject) subjects.push_back({one.subject, {}, one.place});
    UnitSubject& subject = subjects.back();
    subject.place = std::min(subject.place, one.place);
    if (!subject.facts.empty() && subject.facts.back() == one.fact) continue;
    if (++count > max_unit_statements) return std::nullopt;
    subject.facts.push_back(one.fact);
  }
  return subjects;
}

}  // namespace geminga::owl
