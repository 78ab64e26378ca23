// A class expression as conjuncts that can be taken away one by one: those at its top, and those within the filler of a
// restriction.
#ifndef GEMINGA_REASONING_EXPLANATION_ABDUCTION_CONJUNCTS_HPP
#define GEMINGA_REASONING_EXPLANATION_ABDUCTION_CONJUNCTS_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "reasoning/explanation/abduction/minimal_sets.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::abduction {

/// The most conjuncts of one expression. What would be beyond it is not taken apart.
inline constexpr std::size_t max_conjuncts = 64;

/// The expression that defines a named class, as a term of the source; nothing where the class is to stay as it is.
using Definition = std::function<std::optional<owl::TermId>(owl::Ontology& source, owl::TermId named_class)>;

/// The conjuncts of one expression, numbered from 0, outer ones first. A conjunct is nested in one other at most.
///
/// `A and B` has two. `r some (A and B)` and `r min 2 (A and B)` have one, in which two are nested; `r some A` has one.
/// `r only (A and B)` has two, `r only A` and `r only B`, and `not (A or B)` has `not A` and `not B`. A class that
/// has a definition counts as that.
///
/// Taking a conjunct away takes away those that are nested in it, and leaves a more general expression. So a set of
/// conjuncts that are kept has the outer ones of each.
class Conjuncts {
 public:
  /// Adds terms to the source. A definition is taken apart to a depth of max_depth_of_definitions.
  Conjuncts(owl::Ontology& source, owl::TermId expression, const Definition& definition);

  static constexpr int max_depth_of_definitions = 8;

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  /// Whether everything was taken apart that can be.
  [[nodiscard]] bool is_whole() const { return is_whole_; }
  [[nodiscard]] Members all() const;
  /// Those at the top.
  [[nodiscard]] Members top() const { return top_; }
  /// The conjunct and those that are nested in it.
  [[nodiscard]] Members inside(std::size_t conjunct) const { return all_[conjunct].inside; }
  /// The conjunct and those that it is nested in.
  [[nodiscard]] Members around(std::size_t conjunct) const { return all_[conjunct].around; }
  /// The conjunct at the top that has this one.
  [[nodiscard]] std::size_t top_of(std::size_t conjunct) const;
  /// The members that are nested in no other member.
  [[nodiscard]] Members outermost(Members members) const;
  /// The number of members without a nested one among the members: a restriction with its fillers counts as these.
  [[nodiscard]] std::size_t count(Members members) const;

  /// The rest of the expression, owl:Thing if nothing is kept.
  [[nodiscard]] owl::TermId term(owl::Ontology& source, Members kept) const;
  /// The rest of one conjunct, which must be kept.
  [[nodiscard]] owl::TermId term(owl::Ontology& source, std::size_t conjunct, Members kept) const;

 private:
  struct Conjunct {
    owl::TermId whole{};  ///< as it is written; all there is of one without nested ones
    std::vector<std::size_t> nested{};
    Members inside = 0;
    Members around = 0;
  };
  [[nodiscard]] owl::TermId together(owl::Ontology& source, const std::vector<std::size_t>& conjuncts,
                                     Members kept) const;

  std::vector<Conjunct> all_;
  Members top_ = 0;
  bool is_whole_ = true;
};

}  // namespace geminga::abduction

#endif
