// Terms are walked recursively; those of a source nest at most SourceLimits::nesting deep.
#include "compare/edits.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace geminga::compare {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

constexpr std::string_view edited = "http://edit.example/#";
constexpr std::string_view xsd = "http://www.w3.org/2001/XMLSchema#";

/// Quantifiers of object properties; those of data properties stand in the same order.
constexpr TermKind quantifiers[] = {TermKind::object_some_values_from, TermKind::object_all_values_from,
                                    TermKind::object_min_cardinality, TermKind::object_max_cardinality,
                                    TermKind::object_exact_cardinality};
constexpr TermKind data_quantifiers[] = {TermKind::data_some_values_from, TermKind::data_all_values_from,
                                         TermKind::data_min_cardinality, TermKind::data_max_cardinality,
                                         TermKind::data_exact_cardinality};

constexpr AxiomKind characteristics[] = {
    AxiomKind::functional_object_property,  AxiomKind::inverse_functional_object_property,
    AxiomKind::transitive_object_property,  AxiomKind::symmetric_object_property,
    AxiomKind::asymmetric_object_property,  AxiomKind::reflexive_object_property,
    AxiomKind::irreflexive_object_property,
};

bool is_in(std::span<const TermKind> kinds, TermKind kind) { return std::ranges::find(kinds, kind) != kinds.end(); }

/// Whether an edit may put another class expression or data range in the place of such a term.
bool is_part(TermKind kind) { return owl::is_class_expression(kind) || owl::is_data_range(kind); }

/// The parts of such a term must be what they are: the datatype of a literal or a restriction is no range of any kind.
bool is_whole(TermKind kind) { return kind == TermKind::literal || kind == TermKind::datatype_restriction; }

/// Parts of terms that are larger are not looked at.
constexpr std::size_t most_parts = 2'000;

}  // namespace

Editor::Editor(owl::Ontology& terms, std::vector<Statement>& axioms, base::Random& random)
    : terms_(terms), axioms_(axioms), random_(random), is_gathered_(terms.term_count()) {
  for (const Statement& axiom : axioms_)
    for (const TermId id : axiom.arguments) gather(id);
  make_names(classes_, TermKind::named_class, "C", 2);
  make_names(properties_, TermKind::object_property, "p", 2);
  make_names(data_properties_, TermKind::data_property, "d", 1);
  make_names(individuals_, TermKind::individual, "i", 3);
}

void Editor::gather(TermId id) {
  if (is_gathered_[static_cast<std::size_t>(id)]) return;
  is_gathered_[static_cast<std::size_t>(id)] = true;
  const owl::Term term = terms_.term(id);
  for (const TermId part : term.arguments) gather(part);
  if (term.kind > TermKind::individual || terms_.name(term.name).starts_with("http://www.w3.org/2002/07/owl#")) return;
  if (term.kind == TermKind::named_class) classes_.push_back(id);
  if (term.kind == TermKind::object_property) properties_.push_back(id);
  if (term.kind == TermKind::data_property) data_properties_.push_back(id);
  if (term.kind == TermKind::individual) individuals_.push_back(id);
}

void Editor::make_names(std::vector<TermId>& names, TermKind kind, std::string_view letter, std::size_t least) {
  while (names.size() < least) {
    const std::string name = std::string(edited).append(letter) + std::to_string(names.size());
    names.push_back(terms_.entity(kind, name));
  }
}

void Editor::edit() {
  switch (random_.below(10)) {
    case 0:
    case 1:
      return add_about_classes();
    case 2:
    case 3:
      return add_about_properties();
    case 4:
      return add_about_data();
    case 5:
      return add_about_individuals();
    default:
      return change();
  }
}

void Editor::change() {
  if (axioms_.empty()) return;
  Statement& axiom = axioms_[random_.below(axioms_.size())];
  const bool is_of_two = axiom.arguments.size() == 2;
  if (is_of_two && random_.chance(0.15)) {
    if (axiom.kind == AxiomKind::sub_class_of) {
      axiom.kind = AxiomKind::equivalent_classes;
      return;
    }
    if (axiom.kind == AxiomKind::equivalent_classes) {
      axiom.kind = AxiomKind::sub_class_of;
      if (random_.chance(0.5)) std::swap(axiom.arguments.front(), axiom.arguments.back());
      return;
    }
  }
  // The first argument of a disjoint union or datatype definition stays what it must be.
  const bool is_definition = axiom.kind == AxiomKind::disjoint_union || axiom.kind == AxiomKind::datatype_definition;
  const std::size_t first = is_definition ? 1 : 0;
  const std::size_t at = first + random_.below(axiom.arguments.size() - first);
  const std::size_t parts = count_of_parts(axiom.arguments[at]);
  if (parts == 0 || parts > most_parts) return;
  std::size_t countdown = random_.below(parts);
  axiom.arguments[at] = with_part_changed(axiom.arguments[at], countdown);
}

std::size_t Editor::count_of_parts(TermId id) const {
  const owl::Term term = terms_.term(id);
  std::size_t count = is_part(term.kind) ? 1 : 0;
  if (is_whole(term.kind)) return count;
  for (const TermId part : term.arguments) {
    if (count <= most_parts) count += count_of_parts(part);
  }
  return count;
}

/// The term with another one for the part that the countdown, over parts in the order of reading, meets at none.
TermId Editor::with_part_changed(TermId id, std::size_t& countdown) {
  const owl::Term term = terms_.term(id);
  if (is_part(term.kind) && countdown-- == 0) return changed(id);
  std::vector<TermId> arguments(term.arguments.begin(), term.arguments.end());
  for (TermId& part : arguments) {
    const std::size_t parts = count_of_parts(part);
    if (countdown >= parts) {
      countdown -= parts;
      continue;
    }
    part = with_part_changed(part, countdown);
    return terms_.copy(term.kind, std::string(terms_.name(term.name)), term.number, arguments);
  }
  return id;
}

TermId Editor::changed(TermId id) {
  const owl::Term term = terms_.term(id);
  if (is_in(quantifiers, term.kind) || is_in(data_quantifiers, term.kind)) return changed_restriction(term);
  switch (term.kind) {
    case TermKind::object_intersection_of:
    case TermKind::object_union_of:
    case TermKind::object_one_of:
      return changed_list(term);
    case TermKind::object_complement_of:
    case TermKind::data_complement_of:
      return term.arguments.front();
    case TermKind::object_has_value: {
      const TermId with = term.arguments.front();
      const TermId list = terms_.term(TermKind::object_one_of, {term.arguments.back(), any(individuals_)});
      return terms_.term(quantifiers[random_.below(2)], {with, list});
    }
    case TermKind::named_class:
      if (random_.chance(0.3)) return expression();
      [[fallthrough]];
    default:
      if (owl::is_data_range(term.kind)) return range();
      return random_.chance(0.5) ? terms_.term(TermKind::object_complement_of, {id}) : with_another(id);
  }
}

TermId Editor::with_another(TermId id) {
  const TermKind kind = random_.chance(0.5) ? TermKind::object_union_of : TermKind::object_intersection_of;
  return terms_.term(kind, {id, any(classes_)});
}

TermId Editor::restriction(std::span<const TermKind> of, TermId with, TermId filler) {
  const std::size_t at = random_.below(of.size());
  const std::uint32_t least = at > 1 ? number() : 0;
  return terms_.term(of[at], {with, filler}, least);
}

TermId Editor::changed_restriction(const owl::Term& term) {
  const bool is_data = is_in(data_quantifiers, term.kind);
  const TermId with = term.arguments.front();
  TermId filler = term.arguments.size() > 1 ? term.arguments[1]
                  : is_data                 ? terms_.datatype("http://www.w3.org/2000/01/rdf-schema#Literal")
                                            : owl::thing_term;
  if (!is_data && random_.chance(0.1)) filler = any(classes_);
  return restriction(is_data ? data_quantifiers : quantifiers, with, filler);
}

TermId Editor::changed_list(const owl::Term& term) {
  std::vector<TermId> parts(term.arguments.begin(), term.arguments.end());
  const bool is_enumeration = term.kind == TermKind::object_one_of;
  const TermKind other =
      term.kind == TermKind::object_union_of ? TermKind::object_intersection_of : TermKind::object_union_of;
  const TermKind kind = is_enumeration || random_.chance(0.4) ? term.kind : other;
  if (kind != term.kind) return terms_.term(kind, parts);
  if (parts.size() > 2 && random_.chance(0.5)) {
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(random_.below(parts.size())));
  } else {
    parts.push_back(is_enumeration ? any(individuals_) : expression());
  }
  return terms_.term(kind, parts);
}

// Arguments of one call are computed in any order: at most one of them may draw.
void Editor::add_about_classes() {
  const bool is_definition = random_.chance(0.5);
  switch (random_.below(6)) {
    case 0:
      return add(AxiomKind::disjoint_classes, {any(classes_), expression()});
    case 1:
      return add(AxiomKind::equivalent_classes, {any(classes_), expression()});
    case 2: {
      // The nominals of the file's individuals: what a class is made of.
      std::vector<TermId> list;
      for (std::size_t left = 1 + random_.below(4); left > 0; --left) list.push_back(any(individuals_));
      const TermId nominals = terms_.term(TermKind::object_one_of, list);
      return add(is_definition ? AxiomKind::equivalent_classes : AxiomKind::sub_class_of, {any(classes_), nominals});
    }
    case 3:
      return add(AxiomKind::has_key, {any(classes_), random_.chance(0.5) ? any(properties_) : any(data_properties_)});
    case 4:
      return add(AxiomKind::sub_class_of, {expression(), any(classes_)});
    default:
      return add(AxiomKind::sub_class_of, {any(classes_), expression()});
  }
}

void Editor::add_about_properties() {
  switch (random_.below(8)) {
    case 0:
      return add(AxiomKind::object_property_domain, {any(properties_), any(classes_)});
    case 1:
      return add(AxiomKind::object_property_range, {property(), random_.chance(0.7) ? any(classes_) : expression()});
    case 2:
      return add(AxiomKind::sub_object_property_of, {property(), any(properties_)});
    case 3: {
      const TermId chain = terms_.term(TermKind::object_property_chain, {property(), property()});
      return add(AxiomKind::sub_object_property_of, {chain, any(properties_)});
    }
    case 4:
      return add(AxiomKind::inverse_object_properties, {any(properties_), any(properties_)});
    case 5:
      if (random_.chance(0.3)) return add(AxiomKind::disjoint_object_properties, {property(), property()});
      [[fallthrough]];
    default: {
      const AxiomKind characteristic = characteristics[random_.below(std::size(characteristics))];
      return add(characteristic, {any(properties_)});
    }
  }
}

void Editor::add_about_data() {
  const TermId with = any(data_properties_);
  switch (random_.below(6)) {
    case 0:
      return add(AxiomKind::functional_data_property, {with});
    case 1:
      return add(AxiomKind::data_property_domain, {with, any(classes_)});
    case 2:
      return add(AxiomKind::data_property_range, {with, range()});
    case 3:
      return add(AxiomKind::sub_class_of, {any(classes_), terms_.term(TermKind::data_has_value, {with, literal()})});
    case 4: {
      const TermId of = range();
      const TermId some = restriction(data_quantifiers, with, of);
      const bool is_definition = random_.chance(0.3);
      return add(is_definition ? AxiomKind::equivalent_classes : AxiomKind::sub_class_of, {any(classes_), some});
    }
    default:
      return add(AxiomKind::data_property_assertion, {with, any(individuals_), literal()});
  }
}

void Editor::add_about_individuals() {
  const TermId one = any(individuals_);
  const TermId other = any(individuals_);
  if (one == other) return;
  switch (random_.below(8)) {
    case 0:
      return add(AxiomKind::different_individuals, {one, other});
    case 1:
      if (random_.chance(0.5)) return add(AxiomKind::same_individual, {one, other});
      [[fallthrough]];
    case 2:
      return add(AxiomKind::negative_object_property_assertion, {any(properties_), one, other});
    case 3:
    case 4:
      return add(AxiomKind::class_assertion, {random_.chance(0.8) ? any(classes_) : expression(), one});
    default:
      return add(AxiomKind::object_property_assertion, {any(properties_), one, other});
  }
}

TermId Editor::property() {
  const TermId named = any(properties_);
  return random_.chance(0.2) ? terms_.term(TermKind::object_inverse_of, {named}) : named;
}

TermId Editor::expression() {
  const TermId of = any(classes_);
  switch (random_.below(8)) {
    case 0:
      return terms_.term(TermKind::object_complement_of, {of});
    case 1:
      return terms_.term(TermKind::object_has_value, {property(), any(individuals_)});
    case 2:
      return terms_.term(TermKind::object_has_self, {any(properties_)});
    case 3:
      return with_another(of);
    case 4:
      return of;
    default: {
      const TermId with = property();
      return restriction(quantifiers, with, of);
    }
  }
}

TermId Editor::literal() {
  if (random_.chance(0.7)) return terms_.literal(std::to_string(random_.below(8)), std::string(xsd) + "integer");
  return terms_.literal(std::string(1, static_cast<char>('a' + random_.below(3))), std::string(xsd) + "string");
}

TermId Editor::range() {
  const TermId whole = terms_.datatype(std::string(xsd) + "integer");
  switch (random_.below(6)) {
    case 0:
      return terms_.datatype(std::string(xsd) + "string");
    case 1:
      return terms_.datatype(std::string(xsd) + (random_.chance(0.5) ? "boolean" : "nonNegativeInteger"));
    case 2:
      return terms_.term(TermKind::data_one_of, {literal(), literal()});
    case 3:
      return terms_.term(TermKind::data_complement_of, {whole});
    default: {
      const std::uint64_t least = random_.below(8);
      const auto bound = [&](std::string_view facet, std::uint64_t value) {
        return terms_.facet(std::string(xsd).append(facet),
                            terms_.literal(std::to_string(value), std::string(xsd) + "integer"));
      };
      const TermId from = bound("minInclusive", least);
      if (random_.chance(0.5)) return terms_.term(TermKind::datatype_restriction, {whole, from});
      return terms_.term(TermKind::datatype_restriction,
                         {whole, from, bound("maxInclusive", least + random_.below(4))});
    }
  }
}

/// Mostly small, and 41 at most.
std::uint32_t Editor::number() {
  const std::uint64_t draw = random_.below(100);
  if (draw < 5) return 0;
  if (draw < 88) return static_cast<std::uint32_t>(1 + random_.below(3));
  return static_cast<std::uint32_t>(4 + random_.below(draw < 97 ? 9 : 38));
}

}  // namespace geminga::compare
