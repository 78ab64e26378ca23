// Random edits of axioms as people make them: another quantifier, a forgotten disjointness, one characteristic too
// many.
#ifndef GEMINGA_TESTS_COMPARE_EDITS_HPP
#define GEMINGA_TESTS_COMPARE_EDITS_HPP

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::compare {

/// An axiom of a draft, over the terms of the draft's ontology.
struct Statement {
  owl::AxiomKind kind = owl::AxiomKind::declaration;
  std::vector<owl::TermId> arguments;
};

/// Edits a list of axioms, of which `terms` holds the terms. All three must outlive it.
class Editor {
 public:
  /// The names of the axioms are those that edits use. Where there are no properties or individuals, a few are made.
  Editor(owl::Ontology& terms, std::vector<Statement>& axioms, base::Random& random);

  /// Changes a part of a random axiom, or adds one. What the edits make may be outside of OWL 2 DL.
  void edit();

  /// Adds a fact about random individuals, seldom none.
  void add_about_individuals();

 private:
  using TermId = owl::TermId;
  using TermKind = owl::TermKind;
  using AxiomKind = owl::AxiomKind;

  void gather(TermId id);
  void make_names(std::vector<TermId>& names, TermKind kind, std::string_view letter, std::size_t least);
  void change();
  void add_about_classes();
  void add_about_properties();
  void add_about_data();
  void add(AxiomKind kind, std::vector<TermId> arguments) { axioms_.push_back({kind, std::move(arguments)}); }

  [[nodiscard]] std::size_t count_of_parts(TermId id) const;
  TermId with_part_changed(TermId id, std::size_t& countdown);
  TermId changed(TermId id);
  TermId with_another(TermId id);
  TermId restriction(std::span<const TermKind> of, TermId with, TermId filler);
  TermId changed_restriction(const owl::Term& term);
  TermId changed_list(const owl::Term& term);

  TermId any(const std::vector<TermId>& of) { return of[random_.below(of.size())]; }
  TermId property();
  TermId expression();
  TermId literal();
  TermId range();
  std::uint32_t number();

  owl::Ontology& terms_;
  std::vector<Statement>& axioms_;
  base::Random& random_;
  std::vector<bool> is_gathered_;
  std::vector<TermId> classes_;
  std::vector<TermId> properties_;
  std::vector<TermId> data_properties_;
  std::vector<TermId> individuals_;
};

}  // namespace geminga::compare

#endif
