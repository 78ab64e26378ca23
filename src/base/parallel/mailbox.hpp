// A mailbox without a lock for an object that one thread at a time works on.
#ifndef GEMINGA_BASE_PARALLEL_MAILBOX_HPP
#define GEMINGA_BASE_PARALLEL_MAILBOX_HPP

#include <atomic>

namespace geminga::parallel {

/// A stack of messages to one object. The stack is empty while the object is at rest. While a thread owns the object
/// (works on it or has it on a queue) the messages lie on a mark. Message has a pointer `next`; the reader owns the
/// messages that it takes.
template <typename Message>
class Mailbox {
 public:
  /// Marks the object as owned. Requires that no other thread knows it, or that there is one thread.
  void hold() { newest_.store(mark(), std::memory_order_relaxed); }

  /// Takes ownership of the object if it is at rest.
  [[nodiscard]] bool take() {
    Message* at_rest = nullptr;
    return newest_.load(std::memory_order_relaxed) == nullptr &&
           newest_.compare_exchange_strong(at_rest, mark(), std::memory_order_acq_rel);
  }

  /// Puts a message. Returns true if the object was at rest: then the caller owns it, with the message to be read.
  [[nodiscard]] bool put(Message* message) {
    Message* before = newest_.load(std::memory_order_relaxed);
    do {
      message->next = before == mark() ? nullptr : before;
    } while (!newest_.compare_exchange_weak(before, message, std::memory_order_acq_rel, std::memory_order_relaxed));
    return before == nullptr;
  }

  /// Takes the messages, newest first, or nullptr. The caller still owns the object.
  [[nodiscard]] Message* empty() {
    Message* const newest = newest_.exchange(mark(), std::memory_order_acq_rel);
    return newest == mark() ? nullptr : newest;
  }

  /// Puts the object to rest. Returns false if a message has come: then the caller still owns it.
  [[nodiscard]] bool rest() {
    Message* in_hand = mark();
    return newest_.compare_exchange_strong(in_hand, nullptr, std::memory_order_acq_rel);
  }

 private:
  static Message* mark() {
    static Message in_hand;  // only its address is used
    return &in_hand;
  }

  std::atomic<Message*> newest_ = nullptr;
};

}  // namespace geminga::parallel

#endif
