// Axioms of a compiled ontology as a source of their own, to print, reason with and extend.
#ifndef GEMINGA_REASONING_EXPLANATION_EXPLAIN_MODULE_HPP
#define GEMINGA_REASONING_EXPLANATION_EXPLAIN_MODULE_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/explain_minimal.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::explanation {

/// One axiom in readable syntax, e.g. "soccer:SharedBallInfo SubClassOf soccer:BallInfo", with its file and line.
struct ExplainedAxiom {
  std::string text;
  std::string file;
  std::uint32_t line = 0;  ///< 0: unknown
};

/// The axioms that can matter for some classes. Borrows the ontology.
class Module {
 public:
  /// Takes the axioms that can matter for subsumptions of these classes, and for other conclusions about these terms of
  /// the compiled form; the first `most` of them, until complete() takes the others.
  Module(const compiled::Ontology& ontology, std::span<const taxonomy::ClassNumber> classes,
         std::span<const std::uint32_t> more_terms = {}, std::size_t most = std::numeric_limits<std::size_t>::max());

  /// The axioms of the module, in the order in which the walk from the classes reached them.
  [[nodiscard]] const owl::Ontology& source() const { return source_; }
  /// Questions and names for expressions may be added. Axioms that are added have numbers from axiom_count() on.
  [[nodiscard]] owl::Ontology& source() { return source_; }
  [[nodiscard]] std::uint32_t axiom_count() const { return axiom_count_; }
  /// The numbers of all axioms of the module.
  [[nodiscard]] AxiomSet all() const;
  /// Whether the module has axioms that were not taken.
  [[nodiscard]] bool is_begun() const { return is_begun_; }
  /// Takes the axioms of the module that were not taken. To be called before anything else is added.
  void complete();
  /// Adds the other axioms of the ontology to a complete module. To be called before anything else is added. Everything
  /// that follows follows from the module; but an engine with incomplete rules may derive more from more axioms.
  void add_rest();

  [[nodiscard]] const compiled::Ontology& ontology() const { return ontology_; }
  [[nodiscard]] owl::TermId term(taxonomy::ClassNumber number);
  /// Copies a term of the compiled form into the module's source. Recursion is bounded by the nesting of terms.
  owl::TermId copy_term(std::uint32_t term);
  [[nodiscard]] ExplainedAxiom explained(std::uint32_t axiom) const;
  /// The number in the compiled form of an axiom below axiom_count().
  [[nodiscard]] std::uint32_t original(std::uint32_t axiom) const { return originals_[axiom]; }
  /// An axiom by its number in the compiled form, whether it is in the module or not.
  [[nodiscard]] ExplainedAxiom explained_original(std::uint32_t axiom);
  [[nodiscard]] std::string print(owl::TermId term) const;
  /// Orders axioms so that each, if possible, shares an entity with an earlier one, beginning with `first`.
  [[nodiscard]] AxiomSet in_order_of_argument(AxiomSet axioms, owl::TermId first) const;

 private:
  void copy(std::uint32_t axiom);
  /// By number in the compiled form.
  [[nodiscard]] std::vector<bool> copied() const;

  const compiled::Ontology& ontology_;
  std::vector<taxonomy::ClassNumber> classes_;
  std::vector<std::uint32_t> more_terms_;
  bool is_begun_ = false;
  owl::Ontology source_;
  std::uint32_t axiom_count_ = 0;
  std::vector<std::uint32_t> originals_;  ///< of each axiom: its number in the ontology
  std::unordered_map<std::uint32_t, owl::TermId> terms_;
};

}  // namespace geminga::explanation

#endif
