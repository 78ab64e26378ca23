// Checks the sections, array by array.
#include "reasoning/compiled/compiled_checks.hpp"

#include <cmath>
#include <cstdlib>
#include <vector>

#include "reasoning/modules/module_locality.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::compiled {
namespace {

/// A set of kinds of terms.
class Kinds {
 public:
  template <typename Test>
  explicit Kinds(const Test& test) {
    static_assert(owl::term_kind_count <= 64);
    for (std::uint8_t kind = 0; kind < owl::term_kind_count; ++kind) {
      if (test(static_cast<owl::TermKind>(kind))) bits_ |= std::uint64_t{1} << kind;
    }
  }
  [[nodiscard]] bool has(std::uint32_t kind) const { return (bits_ >> kind & 1) != 0; }

 private:
  std::uint64_t bits_ = 0;
};

/// Answers is_well_formed(), for the most frequent forms without going through their grammar.
class Grammar {
 public:
  /// `kind_of` gives the kind of an argument as a number.
  template <typename KindOf>
  [[nodiscard]] bool fits(owl::TermKind kind, taxonomy::ClassifiedView::Numbers arguments, KindOf&& kind_of) {
    if (arguments.empty()) return may_be_bare_.has(static_cast<std::uint32_t>(kind));
    if (kind == owl::TermKind::object_some_values_from) {
      return arguments.size() == 2 && is_role_.has(kind_of(arguments[0])) && is_class_.has(kind_of(arguments[1]));
    }
    if (kind == owl::TermKind::object_intersection_of) return are_classes(arguments, kind_of);
    return is_well_formed(kind, kinds_of(arguments, kind_of));
  }
  template <typename KindOf>
  [[nodiscard]] bool fits(owl::AxiomKind kind, taxonomy::ClassifiedView::Numbers arguments, KindOf&& kind_of) {
    if (kind == owl::AxiomKind::sub_class_of) return arguments.size() == 2 && are_classes(arguments, kind_of);
    if (kind == owl::AxiomKind::equivalent_classes) return arguments.size() >= 2 && are_classes(arguments, kind_of);
    return is_well_formed(kind, kinds_of(arguments, kind_of));
  }

 private:
  template <typename KindOf>
  [[nodiscard]] bool are_classes(taxonomy::ClassifiedView::Numbers arguments, KindOf&& kind_of) const {
    bool is_right = true;
    for (const std::uint32_t term : arguments) is_right &= is_class_.has(kind_of(term));
    return is_right;
  }
  template <typename KindOf>
  [[nodiscard]] std::span<const owl::TermKind> kinds_of(taxonomy::ClassifiedView::Numbers arguments, KindOf&& kind_of) {
    kinds_.clear();
    for (const std::uint32_t argument : arguments) kinds_.push_back(static_cast<owl::TermKind>(kind_of(argument)));
    return kinds_;
  }

  Kinds is_class_{owl::is_class_expression};
  Kinds is_role_{owl::is_object_property_expression};
  Kinds may_be_bare_{[](owl::TermKind kind) { return is_well_formed(kind, {}); }};
  std::vector<owl::TermKind> kinds_;
};

void check_words(const taxonomy::ClassifiedView& view, Checker& check) {
  const auto names = static_cast<std::uint32_t>(view.class_count() + view.name_end.size());
  const auto is_wrong = [&](std::size_t term) {
    return view.term_word[term] >= names &&
           !taxonomy::ClassifiedView::is_cardinality(view.kind_of_term(static_cast<std::uint32_t>(term)));
  };
  std::uint32_t is_large = 0;
  for (const std::uint32_t word : view.term_word) is_large |= static_cast<std::uint32_t>(word >= names);
  for (std::size_t term = 0; is_large != 0 && term < view.term_word.size(); ++term) {
    if (is_wrong(term)) return check.expect(false, "the name of a term", view.term_word, term);
  }
}

/// The arguments of a term must stand before it, so that no term is part of itself, and nest no deeper than readers
/// allow.
void check_forms(const taxonomy::ClassifiedView& view, Checker& check) {
  constexpr std::uint32_t kind_bits = 6;
  constexpr std::uint32_t kind_mask = (1U << kind_bits) - 1;
  static_assert(owl::term_kind_count <= kind_mask && owl::SourceLimits{}.nesting < (1U << (16 - kind_bits)));
  // Kind and depth stand side by side, so that an argument costs one cache miss and not two.
  std::vector<std::uint16_t> shapes(view.term_kind.size());
  const auto kind_of = [&](std::uint32_t term) { return shapes[term] & kind_mask; };
  Grammar grammar;
  for (std::uint32_t term = 0; term < shapes.size(); ++term) {
    const auto arguments = view.arguments_of_term(term);
    std::uint32_t depth = 0;
    for (const std::uint32_t argument : arguments) {
      if (argument >= term) return check.expect(false, "an argument of a term", view.term_begin, term);
      depth = std::max<std::uint32_t>(depth, (shapes[argument] >> kind_bits) + 1U);
    }
    if (depth > owl::SourceLimits{}.nesting) {
      return check.expect(false, "the nesting of a term", view.term_begin, term);
    }
    if (!grammar.fits(view.kind_of_term(term), arguments, kind_of)) {
      return check.expect(false, "the form of a term", view.term_kind, term);
    }
    shapes[term] = static_cast<std::uint16_t>(view.term_kind[term] | depth << kind_bits);
  }
}

void check_terms(const taxonomy::ClassifiedView& view, Checker& check) {
  const std::size_t count = view.term_kind.size();
  check.expect(view.term_word.size() == count, "the number of terms", view.term_word);
  check.ends(view.name_end, view.term_text.size(), "the end of a name");
  check.in_range(view.term_kind, owl::term_kind_count, "the kind of a term");
  check.borders(view.term_begin, count, view.term_arguments.size(), "the border of arguments of a term");
  if (!check.failed()) check_words(view, check);
  if (!check.failed()) check_forms(view, check);
}

void check_statements(const taxonomy::ClassifiedView& view, std::size_t files, std::size_t groups, Checker& check) {
  const std::size_t count = view.axiom_kind.size();
  check.expect(view.axiom_file.size() == count && view.axiom_line.size() == count, "the number of axioms",
               view.axiom_kind);
  check.in_range(view.axiom_kind, owl::axiom_kind_count, "the kind of an axiom");
  check.in_range(view.axiom_file, files, "the file of an axiom");
  check.borders(view.axiom_begin, count, view.axiom_arguments.size(), "the border of arguments of an axiom");
  check.in_range(view.axiom_arguments, view.term_kind.size(), "an argument of an axiom");
  check.expect(view.unused_axiom.size() == view.unused_group.size(), "the number of unused axioms", view.unused_axiom);
  check.in_range(view.unused_axiom, count, "an unused axiom");
  check.in_range(view.unused_group, groups, "the construct of an unused axiom");
  if (check.failed()) return;
  const auto kind_of = [&](std::uint32_t term) -> std::uint32_t { return view.term_kind[term]; };
  Grammar grammar;
  for (std::uint32_t axiom = 0; axiom < count; ++axiom) {
    if (grammar.fits(view.kind_of_axiom(axiom), view.arguments_of_axiom(axiom), kind_of)) continue;
    return check.expect(false, "the form of an axiom", view.axiom_kind, axiom);
  }
}

void check_module_tables(const taxonomy::ClassifiedView& view, Checker& check) {
  const std::size_t terms = view.term_kind.size();
  const std::size_t axioms = view.axiom_kind.size();
  check.expect(view.built_in.size() == modules::built_in_count, "the number of built-in entities", view.built_in);
  check.in_range_or_none(view.built_in, terms, "a built-in entity");
  check.expect(view.uses.size() == terms, "the number of uses", view.uses);
  check.expect(view.term_of_class.size() == view.class_count(), "the number of terms of classes", view.term_of_class);
  check.in_range_or_none(view.term_of_class, terms, "the term of a class");
  check.borders(view.waiting_begin, terms, view.waiting.size(), "the border of axioms that wait for a name");
  check.in_range(view.waiting, axioms, "an axiom that waits for a name");
  check.in_range(view.unconditional, axioms, "an axiom of every module");
}

}  // namespace

void check_taxonomy(const taxonomy::ClassifiedView& view, Checker& check) {
  const std::size_t count = view.class_end.size();
  check.ends(view.class_end, view.class_text.size(), "the end of the IRI of a class");
  check.expect(view.representative.size() == count && view.reach.size() == count, "the number of classes",
               view.representative);
  check.expect(view.thing < count && view.nothing < count, "owl:Thing or owl:Nothing");
  check.in_range(view.representative, count, "the representative of a class");
  if (check.failed()) return;
  for (std::size_t number = 0; number < count; ++number) {
    const std::uint32_t node = view.representative[number];
    if (node == number || view.representative[node] == node) continue;
    return check.expect(false, "the representative of a class", view.representative, number);
  }
  const auto members = taxonomy::ClassifiedView::Numbers(reinterpret_cast<const std::uint32_t*>(view.members.data()),
                                                         view.members.size() * 2);
  check.in_range(members, count, "a class that is equivalent to another");
  check.borders(view.parent_begin, count, view.parents.size(), "the border of parents");
  check.in_range(view.parents, count, "a parent");
  check.borders(view.child_begin, count, view.children.size(), "the border of children");
  check.in_range(view.children, count, "a child");
  std::uint32_t wrong = 0;
  for (const taxonomy::Reach& reach : view.reach) {
    wrong |= static_cast<std::uint32_t>(reach.further_begin > reach.further_end);
    wrong |= static_cast<std::uint32_t>(reach.further_end > view.further.size());
  }
  check.expect(wrong == 0, "the intervals of a class", view.reach);
}

void check_conversions(std::span<const taxonomy::Conversion> conversions, const taxonomy::ClassifiedView& view,
                       Checker& check) {
  check.expect(conversions.size() <= owl::max_conversions, "the number of conversions", conversions);
  const std::uint32_t count = view.class_count();
  for (std::size_t at = 0; at < conversions.size(); ++at) {
    const taxonomy::Conversion& one = conversions[at];
    check.expect(one.from < count && one.to < count, "a class that is converted", conversions, at);
    check.expect(one.cost >= 1 && one.cost <= owl::max_conversion_cost, "the cost of a conversion", conversions, at);
    if (at == 0) continue;
    const taxonomy::Conversion& before = conversions[at - 1];
    const bool ascends = before.from < one.from || (before.from == one.from && before.to < one.to);
    check.expect(ascends, "the order of conversions", conversions, at);
  }
}

void check_units(const UnitsView& units, Checker& check) {
  const std::size_t count = units.size();
  const std::size_t names = units.name_end.size();
  check.expect(count <= owl::max_units, "the number of units", units.factor);
  check.expect(units.offset.size() == count, "the number of offsets of units", units.offset);
  check.expect(units.dimension.size() == count * owl::unit_base_count, "the number of exponents", units.dimension);
  check.expect(units.alone.size() == count, "the number of kinds of units", units.alone);
  check.expect(units.symbol.size() == count, "the number of symbols of units", units.symbol);
  check.expect(units.unit_of_name.size() == names, "the number of names of units", units.unit_of_name);
  check.ends(units.name_end, units.text.size(), "the end of the name of a unit");
  check.in_range(units.unit_of_name, count, "the unit of a name");
  check.in_range_or_none(units.alone, count, "the kind of a unit");
  check.in_range_or_none(units.symbol, names, "the symbol of a unit");
  if (check.failed()) return;
  for (std::size_t unit = 0; unit < count; ++unit) {
    const bool is_factor = std::isnormal(units.factor[unit]) && units.factor[unit] > 0;
    check.expect(is_factor, "the factor of a unit", units.factor, unit);
    check.expect(std::isfinite(units.offset[unit]), "the offset of a unit", units.offset, unit);
  }
  for (std::size_t at = 0; at < units.dimension.size(); ++at) {
    const bool is_exponent = std::abs(int{units.dimension[at]}) <= owl::max_unit_exponent;
    check.expect(is_exponent, "the exponent of a unit", units.dimension, at);
  }
  for (std::size_t name = 1; name < names; ++name) {
    check.expect(units.name(name - 1) < units.name(name), "the order of names of units", units.name_end, name);
  }
}

void check_labels(const LabelsView& labels, const taxonomy::ClassifiedView& taxonomy, Checker& check) {
  check.ends(labels.end, labels.text.size(), "the end of a label");
  check.borders(labels.class_begin, labels.end.size(), labels.classes.size(), "the border of classes of a label");
  check.in_range(labels.classes, taxonomy.class_count(), "the class of a label");
  check.expect(labels.label_of_class.size() == taxonomy.class_count(), "the number of classes with labels",
               labels.label_of_class);
  check.in_range_or_none(labels.label_of_class, labels.end.size(), "the label of a class");
}

void check_axioms(const taxonomy::ClassifiedView& view, std::size_t files, std::size_t groups, Checker& check) {
  check_terms(view, check);
  if (!check.failed()) check_statements(view, files, groups, check);
  if (!check.failed()) check_module_tables(view, check);
}

}  // namespace geminga::compiled
