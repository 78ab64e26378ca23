// One order for the terms and axioms of a source, whatever the order in which they were read; and their digest.
#ifndef GEMINGA_REASONING_OWL_CANONICAL_HPP
#define GEMINGA_REASONING_OWL_CANONICAL_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::owl {

/// How blank nodes count. Their labels differ between files and readers: a digest must not see them, an order must.
enum class BlankNodes { by_label, all_alike };

/// Hashes of what terms and axioms say. Equal content has equal hashes, whatever the source. The members of a set, such
/// as the operands of an intersection, may stand in any order.
class ContentHashes {
 public:
  explicit ContentHashes(const Ontology& source, BlankNodes blank_nodes = BlankNodes::by_label);

  using Hash = std::pair<std::uint64_t, std::uint64_t>;
  [[nodiscard]] Hash hash_of(TermId term) const { return terms_[static_cast<std::size_t>(term)]; }
  [[nodiscard]] Hash hash_of(const Axiom& axiom) const;
  /// The arguments with the members of sets sorted: names first, by name, then expressions.
  [[nodiscard]] std::vector<TermId> sorted(std::span<const TermId> arguments, std::size_t set_from) const;

 private:
  const Ontology& source_;
  std::vector<Hash> terms_;
};

/// The first argument that belongs to a set; the number of arguments if there is no set.
[[nodiscard]] std::size_t set_begin(TermKind kind, std::size_t count);
[[nodiscard]] std::size_t set_begin(AxiomKind kind, std::size_t count);

/// A source in canonical order: files by path; the terms that axioms use, each behind its arguments; each axiom once,
/// at the first place where it stands.
struct CanonicalOrder {
  struct CanonicalAxiom {
    std::uint32_t axiom = 0;  ///< in the source
    std::uint32_t file = 0;   ///< canonical
    std::uint32_t line = 0;
    std::vector<TermId> arguments;
  };
  std::vector<FileId> files;
  std::vector<TermId> terms;
  std::vector<std::uint32_t> number_of_term;  ///< by TermId
  std::vector<CanonicalAxiom> axioms;
  std::vector<std::uint32_t> number_of_axiom;  ///< by axiom of the source; the same for equal ones
};

[[nodiscard]] CanonicalOrder canonical_order(const Ontology& source, const ContentHashes& hashes);

/// The number that identifies an ontology between hosts. It is equal for the same axioms and classes, whatever their
/// order, files or syntax.
[[nodiscard]] std::uint64_t digest(const Ontology& source);

}  // namespace geminga::owl

#endif
