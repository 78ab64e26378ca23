// The successors of one context: the literals about each, and the context in which its things are.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_SUCCESSORS_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_SUCCESSORS_HPP

#include <cstddef>
#include <cstdint>
#include <span>

#include "reasoning/dl/consequence/clause_store.hpp"
#include "reasoning/dl/consequence/pool.hpp"
#include "reasoning/dl/consequence/premise.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"

namespace geminga::consequence {

struct Context;

/// A successor f(x) as the context of x knows it. Literals are in the names of the successor's context.
struct Successor {
  Term f{};
  Term replaced_by{};            ///< where true -> f(x) = t is known; f itself where not
  bool is_certain = false;       ///< something about it has an empty body
  bool is_changed = false;       ///< since the rule Succ was applied to it
  bool knows_existence = false;  ///< the target has been told that it exists
  Pooled<Premise> equations;     ///< processed premises f(x) = t; some are redundant
  Pooled<Premise> premises;      ///< the other processed premises about it, as this context names them
  Pooled<Literal> certain;       ///< A(x) that certainly hold of it; ascending
  Pooled<Literal> possible;      ///< other literals that may hold of it; ascending
  Context* target = nullptr;
  std::size_t told = 0;  ///< how many hypotheses the target has been told
};

/// The table of the clause store also leads from f to its successor, so that a context has one table. Each function
/// takes that store.
class Successors {
 public:
  /// The successor f(x), which is made if there is none. Valid until another is made.
  [[nodiscard]] Successor& at(ClauseStore& store, Term f);
  /// The term that f(x) is known to be; f itself where none is known.
  [[nodiscard]] Term replacement(const ClauseStore& store, Term f) const {
    if (!has_replaced_) return f;
    const std::uint32_t number = store.find_number(successor_key(f));
    return number == 0 ? f : successors_[number - 1].replaced_by;
  }
  [[nodiscard]] bool is_replaced(const ClauseStore& store, Term f) const { return replacement(store, f) != f; }
  /// Notes true -> f(x) = by.
  void replace(Successor& successor, Term by);
  /// Notes a premise about a successor. The successor is valid until another is made.
  Successor& note(ClauseStore& store, const Rules& rules, Premise premise);

  [[nodiscard]] bool has_changed() const { return !changed_.empty(); }
  /// A successor that changed since the rule Succ was applied to it.
  [[nodiscard]] Successor& take_changed();

  [[nodiscard]] std::span<Successor> all() { return successors_; }
  [[nodiscard]] std::span<const Successor> all() const { return successors_; }

 private:
  void mark_changed(Successor& successor);

  Pooled<Successor> successors_;
  Pooled<std::uint32_t> changed_;
  bool has_replaced_ = false;
};

}  // namespace geminga::consequence

#endif
