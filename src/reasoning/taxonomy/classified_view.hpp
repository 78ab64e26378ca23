// A classified ontology as arrays of numbers: its taxonomy, its terms and its axioms.
#ifndef GEMINGA_REASONING_TAXONOMY_CLASSIFIED_VIEW_HPP
#define GEMINGA_REASONING_TAXONOMY_CLASSIFIED_VIEW_HPP

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "reasoning/owl/axiom.hpp"
#include "reasoning/taxonomy/interval.hpp"
#include "reasoning/taxonomy/reach.hpp"

namespace geminga::taxonomy {

/// A class that is equivalent to a smaller one, its representative.
struct EquivalentMember {
  std::uint32_t node = 0;
  std::uint32_t other = 0;
  friend auto operator<=>(const EquivalentMember&, const EquivalentMember&) = default;
};

/// Borrowed spans. Every number in them is in range. An ontology has two views: one of its taxonomy, and one of its
/// taxonomy with terms and axioms.
struct ClassifiedView {
  using Numbers = std::span<const std::uint32_t>;
  /// Stands for no name or no term.
  static constexpr std::uint32_t none = 0xffffffff;

  std::uint64_t digest = 0;
  bool is_consistent = true;
  std::string_view class_text;
  Numbers class_end;
  Numbers representative;
  std::uint32_t thing = 0;
  std::uint32_t nothing = 0;
  std::span<const EquivalentMember> members;
  Numbers parent_begin;
  Numbers parents;
  Numbers child_begin;
  Numbers children;
  std::span<const Reach> reach;
  std::span<const Interval> further;

  std::string_view term_text;
  Numbers name_end;
  std::span<const std::uint8_t> term_kind;
  Numbers term_word;
  Numbers term_begin;
  Numbers term_arguments;
  std::span<const std::uint8_t> axiom_kind;
  std::span<const std::uint16_t> axiom_file;
  Numbers axiom_line;
  Numbers axiom_begin;
  Numbers axiom_arguments;
  Numbers unused_axiom;
  Numbers unused_group;
  Numbers built_in;
  Numbers uses;
  Numbers term_of_class;
  Numbers waiting_begin;
  Numbers waiting;
  Numbers unconditional;

  [[nodiscard]] std::uint32_t class_count() const { return static_cast<std::uint32_t>(class_end.size()); }
  [[nodiscard]] std::string_view class_iri(std::uint32_t number) const { return piece(class_text, class_end, number); }
  [[nodiscard]] Numbers parents_of(std::uint32_t node) const { return row(parent_begin, parents, node); }
  [[nodiscard]] Numbers children_of(std::uint32_t node) const { return row(child_begin, children, node); }

  [[nodiscard]] std::uint32_t term_count() const { return static_cast<std::uint32_t>(term_kind.size()); }
  [[nodiscard]] std::uint32_t axiom_count() const { return static_cast<std::uint32_t>(axiom_kind.size()); }
  [[nodiscard]] owl::TermKind kind_of_term(std::uint32_t term) const {
    return static_cast<owl::TermKind>(term_kind[term]);
  }
  [[nodiscard]] owl::AxiomKind kind_of_axiom(std::uint32_t axiom) const {
    return static_cast<owl::AxiomKind>(axiom_kind[axiom]);
  }
  /// The name of an entity, literal, language tag or facet; empty for others.
  [[nodiscard]] std::string_view name_of_term(std::uint32_t term) const {
    if (is_cardinality(kind_of_term(term))) return {};
    const std::uint32_t name = term_word[term];
    return name < class_count() ? class_iri(name) : piece(term_text, name_end, name - class_count());
  }
  /// The number of a cardinality; 0 for others.
  [[nodiscard]] std::uint32_t number_of_term(std::uint32_t term) const {
    return is_cardinality(kind_of_term(term)) ? term_word[term] : 0;
  }
  [[nodiscard]] Numbers arguments_of_term(std::uint32_t term) const { return row(term_begin, term_arguments, term); }
  [[nodiscard]] Numbers arguments_of_axiom(std::uint32_t axiom) const {
    return row(axiom_begin, axiom_arguments, axiom);
  }
  [[nodiscard]] Numbers axioms_waiting_for(std::uint32_t entity) const { return row(waiting_begin, waiting, entity); }

  [[nodiscard]] static bool is_cardinality(owl::TermKind kind) {
    return (kind >= owl::TermKind::object_min_cardinality && kind <= owl::TermKind::object_exact_cardinality) ||
           (kind >= owl::TermKind::data_min_cardinality && kind <= owl::TermKind::data_exact_cardinality);
  }
  [[nodiscard]] static Numbers row(Numbers begin, Numbers items, std::uint32_t at) {
    return items.subspan(begin[at], begin[at + 1] - begin[at]);
  }
  [[nodiscard]] static std::string_view piece(std::string_view text, Numbers ends, std::uint32_t at) {
    const std::size_t begin = at == 0 ? 0 : ends[at - 1];
    return text.substr(begin, ends[at] - begin);
  }
};

}  // namespace geminga::taxonomy

#endif
