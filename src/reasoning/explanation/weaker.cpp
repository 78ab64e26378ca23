// The transformation of Horridge, Parsia and Sattler (2008): a subclass may become smaller, a superclass larger.
#include "reasoning/explanation/weaker.hpp"

#include <algorithm>
#include <utility>

namespace geminga::explanation {
namespace {

using owl::AxiomKind;
using owl::Ontology;
using owl::Term;
using owl::TermId;
using owl::TermKind;

/// Whether instances are to be added or taken away.
enum class Change : bool { larger, smaller };

constexpr Change opposite(Change change) { return change == Change::larger ? Change::smaller : Change::larger; }

constexpr TermId end_of(Change change) { return change == Change::larger ? owl::thing_term : owl::nothing_term; }

/// A copy, because a term of a source is valid only until the next one is added.
std::vector<TermId> arguments_of(const Ontology& source, TermId term) {
  const auto arguments = source.term(term).arguments;
  return {arguments.begin(), arguments.end()};
}

/// The conjuncts of an intersection, or the term itself.
std::vector<TermId> conjuncts(const Ontology& source, TermId term) {
  if (source.kind(term) == TermKind::object_intersection_of) return arguments_of(source, term);
  return {term};
}

std::vector<TermId> disjuncts(const Ontology& source, TermId term) {
  if (source.kind(term) == TermKind::object_union_of) return arguments_of(source, term);
  return {term};
}

/// Lists the forms of one term.
class Forms {
 public:
  explicit Forms(Ontology& source) : source_(source) {}

  /// The terms that are larger (or smaller) than this one, those that are furthest from it first. Recursion is bounded
  /// by the nesting of terms.
  std::vector<TermId> of(TermId term, Change change) {
    std::vector<TermId> forms;
    if (term == end_of(change)) return forms;
    forms.push_back(end_of(change));
    const TermKind kind = source_.kind(term);
    const std::vector<TermId> arguments = arguments_of(source_, term);
    switch (kind) {
      case TermKind::object_intersection_of:
      case TermKind::object_union_of:
        add_with_fewer(kind, arguments, change, forms);
        break;
      case TermKind::object_complement_of:
        for (const TermId form : of(arguments[0], opposite(change))) add(kind, {form}, forms);
        break;
      case TermKind::object_some_values_from:
      case TermKind::object_all_values_from:
        for (const TermId form : of(arguments[1], change)) add(kind, {arguments[0], form}, forms);
        break;
      case TermKind::object_has_value:
        if (change == Change::larger) add(TermKind::object_some_values_from, {arguments[0], owl::thing_term}, forms);
        break;
      case TermKind::object_min_cardinality:
      case TermKind::object_max_cardinality:
      case TermKind::object_exact_cardinality:
        add_cardinalities(kind, source_.term(term).number, arguments, change, forms);
        break;
      default:
        break;
    }
    std::erase_if(forms, [&](TermId form) { return form == term; });
    return forms;
  }

 private:
  void add(TermKind kind, std::vector<TermId> arguments, std::vector<TermId>& forms, std::uint32_t number = 0) {
    forms.push_back(source_.term(kind, arguments, number));
  }

  /// Replaces one operand by each of its forms. One that says nothing any more is left out.
  void add_with_fewer(TermKind kind, const std::vector<TermId>& operands, Change change, std::vector<TermId>& forms) {
    const TermId neutral = kind == TermKind::object_intersection_of ? owl::thing_term : owl::nothing_term;
    for (std::size_t at = 0; at < operands.size(); ++at) {
      for (const TermId form : of(operands[at], change)) {
        std::vector<TermId> some = operands;
        if (form == neutral) {
          some.erase(some.begin() + static_cast<std::ptrdiff_t>(at));
        } else if (form == end_of(change)) {
          continue;  // the whole term becomes that, which is among the forms
        } else {
          some[at] = form;
        }
        if (some.size() == 1) {
          forms.push_back(some.front());
        } else {
          add(kind, std::move(some), forms);
        }
      }
    }
  }

  void add_cardinalities(TermKind kind, std::uint32_t number, const std::vector<TermId>& arguments, Change change,
                         std::vector<TermId>& forms) {
    if (kind == TermKind::object_exact_cardinality) {
      if (change == Change::smaller) return;
      if (number > 0) add(TermKind::object_min_cardinality, arguments, forms, number);
      add(TermKind::object_max_cardinality, arguments, forms, number);
      return;
    }
    const bool is_min = kind == TermKind::object_min_cardinality;
    if (is_min && change == Change::larger && number > 1) {
      add(kind, arguments, forms, 1);
      if (number > 2) add(kind, arguments, forms, number - 1);
    }
    if (arguments.size() < 2) return;
    for (const TermId form : of(arguments[1], is_min ? change : opposite(change)))
      add(kind, {arguments[0], form}, forms, number);
  }

  Ontology& source_;
};

void add_inclusions(const Ontology& source, TermId sub, TermId super, std::vector<Part>& parts) {
  for (const TermId below : disjuncts(source, sub)) {
    for (const TermId above : conjuncts(source, super)) {
      if (below != above) parts.push_back({AxiomKind::sub_class_of, {below, above}});
    }
  }
}

/// An axiom of this kind for each two of these terms.
void add_pairs(AxiomKind kind, std::span<const TermId> terms, std::vector<Part>& parts) {
  for (std::size_t one = 0; one < terms.size(); ++one) {
    for (std::size_t other = one + 1; other < terms.size(); ++other)
      parts.push_back({kind, {terms[one], terms[other]}});
  }
}

/// Pairs of more terms would be too many: such an axiom stays whole.
constexpr std::size_t max_paired_terms = 24;

}  // namespace

std::vector<Part> parts_of(Ontology& source, const owl::Axiom& axiom) {
  const std::vector<TermId> arguments(axiom.arguments.begin(), axiom.arguments.end());
  const AxiomKind kind = axiom.kind;
  std::vector<Part> parts;
  switch (kind) {
    case AxiomKind::sub_class_of:
      add_inclusions(source, arguments[0], arguments[1], parts);
      break;
    case AxiomKind::equivalent_classes:
      if (arguments.size() > max_paired_terms) break;
      for (const TermId one : arguments) {
        for (const TermId other : arguments) {
          if (one != other) add_inclusions(source, one, other, parts);
        }
      }
      break;
    case AxiomKind::disjoint_union: {
      const std::vector<TermId> operands(arguments.begin() + 1, arguments.end());
      if (operands.size() > max_paired_terms || operands.size() < 2) break;
      parts.push_back({AxiomKind::sub_class_of, {arguments[0], source.term(TermKind::object_union_of, operands)}});
      for (const TermId operand : operands) add_inclusions(source, operand, arguments[0], parts);
      add_pairs(AxiomKind::disjoint_classes, operands, parts);
      break;
    }
    case AxiomKind::disjoint_classes:
    case AxiomKind::disjoint_object_properties:
    case AxiomKind::disjoint_data_properties:
    case AxiomKind::different_individuals:
      if (arguments.size() <= max_paired_terms) add_pairs(kind, arguments, parts);
      break;
    case AxiomKind::equivalent_object_properties:
    case AxiomKind::equivalent_data_properties: {
      if (arguments.size() > max_paired_terms) break;
      const bool is_object = kind == AxiomKind::equivalent_object_properties;
      for (const TermId one : arguments) {
        for (const TermId other : arguments) {
          if (one == other) continue;
          parts.push_back(
              {is_object ? AxiomKind::sub_object_property_of : AxiomKind::sub_data_property_of, {one, other}});
        }
      }
      break;
    }
    case AxiomKind::object_property_domain:
    case AxiomKind::object_property_range:
    case AxiomKind::data_property_domain:
      for (const TermId part : conjuncts(source, arguments[1])) parts.push_back({kind, {arguments[0], part}});
      break;
    case AxiomKind::class_assertion:
      for (const TermId part : conjuncts(source, arguments[0])) parts.push_back({kind, {part, arguments[1]}});
      break;
    default:
      break;
  }
  if (parts.empty()) parts.push_back({kind, arguments});
  return parts;
}

std::vector<Part> weaker_forms(Ontology& source, const Part& part) {
  std::vector<Part> weaker;
  Forms forms(source);
  const auto change = [&](std::size_t at, Change how) {
    for (const TermId form : forms.of(part.arguments[at], how)) {
      if (form == end_of(how)) continue;  // such an axiom follows from nothing
      Part one = part;
      one.arguments[at] = form;
      weaker.push_back(std::move(one));
    }
  };
  switch (part.kind) {
    case AxiomKind::sub_class_of:
      change(1, Change::larger);
      change(0, Change::smaller);
      break;
    case AxiomKind::object_property_domain:
    case AxiomKind::object_property_range:
    case AxiomKind::data_property_domain:
      change(1, Change::larger);
      break;
    case AxiomKind::class_assertion:
      change(0, Change::larger);
      break;
    case AxiomKind::disjoint_classes:
      for (std::size_t at = 0; at < part.arguments.size(); ++at) change(at, Change::smaller);
      break;
    default:
      break;
  }
  return weaker;
}

}  // namespace geminga::explanation
