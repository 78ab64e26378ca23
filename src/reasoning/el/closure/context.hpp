// A context of a saturation: the conclusions about one concept, and the messages between contexts.
#ifndef GEMINGA_REASONING_EL_CLOSURE_CONTEXT_HPP
#define GEMINGA_REASONING_EL_CLOSURE_CONTEXT_HPP

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/arena_containers.hpp"
#include "base/growing_set.hpp"
#include "base/parallel/mailbox.hpp"
#include "base/stable_store.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

/// One link of a context: the role and the context at the other end.
struct Link {
  RoleId role{};
  std::uint32_t context = 0;
  friend bool operator==(const Link&, const Link&) = default;
};
[[nodiscard]] inline std::uint64_t hash_of_key(Link link) {
  return ((static_cast<std::uint64_t>(link.role) << 32 | link.context) * 0x9e3779b97f4a7c15ULL) >> 20;
}

/// The successors of a context by a functional role and its sub-roles: they are one.
struct FunctionalGroup {
  RoleId functional{};
  std::uint32_t successor = 0;  ///< the context of all successors together
  std::vector<RoleId> roles;    ///< the roles by which it is a successor
};

/// A vector that most contexts do not have: a null pointer until an item comes.
template <typename T>
class RareList {
 public:
  [[nodiscard]] const std::vector<T>& get() const {
    static const std::vector<T> nothing;
    return items_ == nullptr ? nothing : *items_;
  }
  [[nodiscard]] std::vector<T>& own() {
    if (items_ == nullptr) items_ = std::make_unique<std::vector<T>>();
    return *items_;
  }
  void clear() { items_.reset(); }
  [[nodiscard]] bool empty() const { return items_ == nullptr || items_->empty(); }
  [[nodiscard]] std::size_t size() const { return items_ == nullptr ? 0 : items_->size(); }
  [[nodiscard]] const T& operator[](std::size_t at) const { return (*items_)[at]; }
  [[nodiscard]] auto begin() const { return get().begin(); }
  [[nodiscard]] auto end() const { return get().end(); }

 private:
  std::unique_ptr<std::vector<T>> items_;
};

/// A message to a context, which is "it" below.
struct Message {
  enum class Kind : std::uint8_t {
    subsumer,  ///< it is below an expression, `first`
    backward,  ///< a link of the role `first` from the context `second` ends in it
    forward,   ///< a link of the role `first` from it ends in the context `second`
    bottom,    ///< it is unsatisfiable
    last,      ///< as backward, of a link that need not be the first of a composition
  };
  Kind kind = Kind::subsumer;
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  friend bool operator==(const Message&, const Message&) = default;
};

/// A message that waits for the thread that will work on the context.
struct QueuedMessage {
  QueuedMessage* next = nullptr;
  Message message;
};

/// The conclusions about one atom, or about several together. The tails of its lists behind the cursors (`..._done`)
/// are its work queue: a conclusion is tested for being new before it is queued, and every pair of premises meets once.
struct alignas(64) Context {
  base::ArenaSet<std::uint32_t> subsumers;  ///< active expressions, and marks of disjointness axioms behind them
  std::uint32_t subsumers_done = 0;
  ExprId root{};  ///< F if it is of several atoms together
  bool is_unsatisfiable = false;
  bool is_nonempty = false;  ///< it has an instance in every model; followed only if there are nominals
  bool is_queued = false;
  /// Among many threads: the rank of the worker that holds the context, or 0. Only the holder may rely on it.
  std::atomic<std::uint8_t> owner = 0;
  /// Messages from other threads, the last first.
  parallel::Mailbox<QueuedMessage> mailbox;
  base::ArenaSet<Link> backward;  ///< links that end here
  std::uint32_t backward_done = 0;
  base::ArenaSet<Link> firsts;  ///< links of these that may be the first of a composition
  std::uint32_t firsts_done = 0;
  std::uint32_t forward_done = 0;
  std::uint32_t selfs_done = 0;
  base::ArenaList<Link> forward;        ///< links that begin here, if a rule asks for them
  base::ArenaList<ExprId> propagating;  ///< subsumers with existential rules
  base::ArenaList<ExprId> derived;      ///< atoms above that no told axiom puts there
  RareList<ExprId> together;            ///< the atoms, ascending, if it is of several
  RareList<RoleId> selfs;
  RareList<FunctionalGroup> groups;
  RareList<ExprId> restricting;      ///< subsumers with universal rules
  RareList<std::uint32_t> nominals;  ///< contexts of the nominals above, without itself
  RareList<std::uint32_t> members;   ///< of a nominal's context: the contexts below it
};

using ContextStore = base::StableStore<Context>;

}  // namespace geminga::el

#endif
