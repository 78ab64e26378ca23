// Files conclusions in their context: simplifies them, drops what is redundant, and queues the rest.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_FILING_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_FILING_HPP

#include <cstddef>
#include <span>
#include <vector>

#include "reasoning/dl/consequence/conclusions.hpp"
#include "reasoning/dl/consequence/context.hpp"
#include "reasoning/dl/consequence/effort.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"

namespace geminga::consequence {

/// The number of maximal literals of a head that is in order. In a context that answers queries none of its query
/// literals is above another, and all of them are maximal.
[[nodiscard]] std::size_t maximal_count(const Rules& rules, bool answers_queries, std::span<const Literal> head);

/// Of a context, Filing reads the successors and changes the store, the queue and has_open.
class Filing {
 public:
  Filing(const Rules& rules, Effort& effort, SharedEffort& shared) : rules_(rules), effort_(effort), shared_(shared) {}

  /// Files all conclusions. False: the context is unsatisfiable.
  [[nodiscard]] bool file(const Conclusions& conclusions, Context& context);

 private:
  // False: the clause is true -> false.
  bool add_unit(Literal literal, Context& context);
  bool add_clause(Context& context);
  /// Simplifies head_. False: the clause is true.
  [[nodiscard]] bool simplify_head(const Context& context);
  void note_open(Literal literal, Context& context) const {
    if (literal.kind() == LiteralKind::unary && rules_.is_open(literal.predicate())) context.has_open = true;
  }

  const Rules& rules_;
  Effort& effort_;
  SharedEffort& shared_;
  // Room for the clause that is filed.
  std::vector<Literal> body_;
  std::vector<Literal> head_;
};

}  // namespace geminga::consequence

#endif
