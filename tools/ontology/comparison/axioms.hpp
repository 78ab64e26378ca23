// Axioms of two ontologies compared by what they say, in whichever of several forms they say it.
#ifndef GEMINGA_ONTOLOGY_COMPARISON_AXIOMS_HPP
#define GEMINGA_ONTOLOGY_COMPARISON_AXIOMS_HPP

#include <map>
#include <set>
#include <vector>

#include "reasoning/owl/canonical.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::ontology {

/// Hashes of what the axioms of one ontology say, which must outlive it. Anonymous individuals count as alike, because
/// their labels are those of a file: two axioms that differ in nothing else are one.
class Contents {
 public:
  using Hash = owl::ContentHashes::Hash;

  explicit Contents(const owl::Ontology& source);

  /// Equal for a fact of an inverse and the reverse fact, and for inverses of two inverses and of their properties.
  [[nodiscard]] Hash hash_of(const owl::Axiom& axiom) const;
  /// The members of an equivalence, or of the same individual. Empty for other axioms, and where an anonymous
  /// individual is in one: it is alike to others and not the same.
  [[nodiscard]] std::vector<Hash> same_things(const owl::Axiom& axiom) const;

 private:
  const owl::Ontology& source_;
  owl::ContentHashes hashes_;
  std::vector<bool> holds_blank_;  ///< by term
};

/// The axioms of one ontology, to be looked up from another.
class Axioms {
 public:
  explicit Axioms(const owl::Ontology& source);

  /// Whether an axiom of another source is among them. Triples say that n things are the same by n - 1 pairs: such an
  /// axiom is there where pairs connect its members, and a pair where an axiom of more holds both.
  [[nodiscard]] bool has(const Contents& contents, const owl::Axiom& axiom) const;

 private:
  /// Things that are the same, as a forest of hashes.
  class Groups {
   public:
    void join(const std::vector<Contents::Hash>& members);
    /// Follows the last join(), and precedes questions.
    void settle();
    [[nodiscard]] bool have_together(const std::vector<Contents::Hash>& members) const;

   private:
    /// Shortens the way to the root, so that a long chain is walked once.
    Contents::Hash root(Contents::Hash member);
    std::map<Contents::Hash, Contents::Hash> above_;  ///< a root is above itself
  };

  std::set<Contents::Hash> known_;
  Groups all_;
  Groups of_more_than_two_;
};

}  // namespace geminga::ontology

#endif
