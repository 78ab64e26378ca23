// The messages between contexts, and the mailbox in which they wait.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_MAILBOX_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_MAILBOX_HPP

#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>

#include "reasoning/dl/consequence/pool.hpp"
#include "reasoning/dl/consequence/rules/literal.hpp"

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

/// The meaning of a message between contexts.
enum class MessageKind : std::uint8_t {
  start,    ///< the context is new
  edge,     ///< the things f(x) of the sender are in the context; the body's literals may hold of them
  no_edge,  ///< the things f(x) of the sender have moved to another context
  clause,   ///< a clause about the successor f(x), in the successor's names
  exists,   ///< something certainly is in the context
  inherit,  ///< the sender's things are the nominal that the receiver is about
  fact,     ///< the head's literal certainly holds
};
struct Message {
  MessageKind kind = MessageKind::start;
  Term f{};
  Context* from = nullptr;
  std::uint32_t body = 0;  ///< number of literals, which follow those of earlier messages
  std::uint32_t head = 0;
};

/// Messages in the order in which they were sent. Any thread may put one in; only the thread that works on the context
/// takes them out.
class Mailbox {
 public:
  /// Adds a message with its literals. True: nobody works on the context, which is to be scheduled.
  [[nodiscard]] bool put(MessageKind kind, Context* from, Term f, std::span<const Literal> body,
                         std::span<const Literal> head) {
    const std::lock_guard guard(lock_);
    messages_.push_back(
        {kind, f, from, static_cast<std::uint32_t>(body.size()), static_cast<std::uint32_t>(head.size())});
    literals_.insert(literals_.end(), body.begin(), body.end());
    literals_.insert(literals_.end(), head.begin(), head.end());
    if (is_scheduled_) return false;
    is_scheduled_ = true;
    return true;
  }
  /// Moves all messages into `messages` and `literals`. False: there is none, or `is_cut_off`; the context is no more
  /// scheduled.
  [[nodiscard]] bool take(Pooled<Message>& messages, Pooled<Literal>& literals, bool is_cut_off) {
    messages.clear();
    literals.clear();
    const std::lock_guard guard(lock_);
    if (messages_.empty() || is_cut_off) {
      is_scheduled_ = false;
      return false;
    }
    messages.swap(messages_);
    literals.swap(literals_);
    return true;
  }

 private:
  SpinLock lock_;
  Pooled<Message> messages_;
  Pooled<Literal> literals_;
  bool is_scheduled_ = false;
};

}  // namespace geminga::consequence

#endif
