// One context: what is known about all things of which its core holds, with its successors and predecessors.
//
// One thread at a time works on a context. Others only post messages into its mailbox.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_CONTEXT_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_CONTEXT_HPP

#include <atomic>
#include <cstdint>
#include <limits>
#include <mutex>

#include "reasoning/dl/consequence/clause_store.hpp"

namespace geminga::consequence {

/// A lock of one octet that is held for a few instructions. Each context has one.
class SpinLock {
 public:
  void lock() {
    while (flag_.test_and_set(std::memory_order_acquire)) flag_.wait(true, std::memory_order_relaxed);
  }
  void unlock() {
    flag_.clear(std::memory_order_release);
    flag_.notify_one();
  }

 private:
  std::atomic_flag flag_;
};

struct Context;

/// What a message between contexts says.
enum class MessageKind : std::uint8_t {
  start,    ///< the context is new
  edge,     ///< the things f(x) of the sender are there; the body's literals may hold of them
  no_edge,  ///< they have moved to another context
  clause,   ///< of the successor f(x), in the successor's names
  exists,   ///< some thing is in the context for certain
  inherit,  ///< the sender's things are the nominal that the receiver is about
  fact,     ///< the head's literal holds for certain
};
struct Message {
  MessageKind kind = MessageKind::start;
  Term f{};
  Context* from = nullptr;
  std::uint32_t body = 0;  ///< literals, which follow those of the messages before
  std::uint32_t head = 0;
};

/// The key of a context. Private contexts belong to one function symbol, whose things are not certain to exist.
struct ContextKey {
  Pooled<Literal> core;  ///< ascending
  std::uint32_t function = std::numeric_limits<std::uint32_t>::max();
  bool is_value = false;  ///< its members are values: what is said of every thing is not said of them
  friend bool operator==(const ContextKey&, const ContextKey&) = default;
};

/// The things f(x) of the things x of `from` are in this context, as far as the hypotheses hold of them.
struct Edge {
  Context* from = nullptr;
  Term f{};
  bool is_live = true;
  Pooled<Literal> hypotheses;  ///< ascending
};

/// A successor f(x) as the context of x knows it. Literals are in the names of the successor's context.
struct Successor {
  Term f{};
  Term replaced_by{};            ///< where true -> f(x) = t is known; f itself where not
  bool is_certain = false;       ///< something about it has an empty body
  bool is_changed = false;       ///< since Succ has seen it
  bool knows_existence = false;  ///< the target has been told that it exists
  Pooled<Literal> literals;      ///< maximal literals about it, as this context names them
  Pooled<Literal> certain;       ///< A(x) that certainly hold of it
  Pooled<Literal> possible;      ///< whatever else may
  Context* target = nullptr;
  std::size_t told = 0;  ///< how many hypotheses the target has been told
};

/// A clause of a successor that waits for its body to hold, in the names of the context that has it.
struct ForeignClause {
  Pooled<Literal> body;
  Pooled<Literal> head;
};

struct Context {
  std::uint32_t number = 0;
  ContextKey key;
  /// Whether its units are asked for; see Rules::is_query().
  bool answers_queries = false;
  bool is_unsatisfiable = false;
  bool has_open = false;           ///< something open is in the head of a clause, see RuleSet::is_open
  bool has_replaced = false;       ///< some successor is known to be another term
  bool is_nonempty = false;        ///< some thing is in it for certain; see nominals.cpp
  bool is_cut = false;             ///< it had too many alternatives and keeps what has none, see Worker::cut()
  std::uint32_t alternatives = 0;  ///< work done on clauses with more than one literal in the head
  ClauseStore store;
  Pooled<Literal> unit_queue;
  Pooled<ClauseNumber> clause_queue;
  Pooled<Successor> successors;
  Pooled<std::uint32_t> changed_successors;
  Pooled<Edge> edges;
  Pooled<ClauseNumber> for_all_edges;  ///< clauses with an empty body that every predecessor gets
  Pooled<Literal> units_for_edges;
  Pooled<ForeignClause> foreign;
  Pooled<std::uint32_t> nominals;  ///< that x is
  Pooled<Literal> facts;           ///< that were told
  Pooled<Context*> inheritors;

  SpinLock lock;  ///< guards what follows
  Pooled<Message> mailbox;
  Pooled<Literal> mailbox_literals;
  bool is_scheduled = false;
};

}  // namespace geminga::consequence

#endif
