// One worker's queue of contexts or nodes, and its messages to those that other workers hold.
//
// One worker at a time holds a context, and only its holder touches it. A conclusion about a context that this worker
// holds is noted at once. A context that nobody holds is taken first. For a context that another worker holds, a
// message goes into its mailbox. So there is no lock around a closure (threads.hpp says how queues are shared).
#ifndef GEMINGA_REASONING_EL_CLOSURE_CONTEXT_QUEUE_HPP
#define GEMINGA_REASONING_EL_CLOSURE_CONTEXT_QUEUE_HPP

#include <atomic>
#include <cstdint>
#include <vector>

namespace geminga::el {

/// Store has contexts by number; each has an owner, a mailbox of QueuedMessage and is_queued.
template <typename Store, typename QueuedMessage>
class ContextQueue {
 public:
  /// Ranks of workers are from 1.
  ContextQueue(Store& contexts, std::uint8_t rank) : contexts_(contexts), rank_(rank) {}

  [[nodiscard]] std::uint8_t rank() const { return rank_; }
  /// The contexts to be worked on, the next one last.
  [[nodiscard]] std::vector<std::uint32_t>& numbers() { return numbers_; }
  [[nodiscard]] bool is_parallel() const { return is_parallel_; }

  /// Begins or ends work by several workers. This worker holds the contexts on its queue from then on.
  void set_parallel(bool is_parallel) {
    is_parallel_ = is_parallel;
    if (!is_parallel) return;
    for (const std::uint32_t context : numbers_) {
      contexts_[context].mailbox.hold();
      contexts_[context].owner = rank_;
      contexts_[context].is_queued = false;
    }
  }

  /// True if this worker does not hold the context.
  [[nodiscard]] bool is_elsewhere(std::uint32_t context) const {
    return is_parallel_ && contexts_[context].owner.load(std::memory_order_relaxed) != rank_;
  }

  /// Holds and queues a new context. Requires that no other worker knows it.
  void add(std::uint32_t context) {
    if (is_parallel_) {
      contexts_[context].mailbox.hold();
      return own(context);
    }
    enqueue(context);
  }

  /// Queues a context again that this worker holds; among several workers it is on the queue or being worked on.
  void enqueue(std::uint32_t context) {
    if (is_parallel_ || contexts_[context].is_queued) return;
    contexts_[context].is_queued = true;
    numbers_.push_back(context);
  }

  /// Holds and queues the context if nobody holds it.
  [[nodiscard]] bool take(std::uint32_t context) {
    if (!contexts_[context].mailbox.take()) return false;
    own(context);
    return true;
  }

  /// Puts a message into the mailbox of a context, and takes the context if its holder has released it.
  void post(std::uint32_t context, QueuedMessage* message) {
    if (contexts_[context].mailbox.put(message)) own(context);
  }

  /// Works on the contexts of the queue until it is empty, as the only worker.
  template <typename Process, typename HasEnded>
  void run_alone(Process&& process, HasEnded&& has_ended) {
    while (!numbers_.empty() && !has_ended()) {
      const std::uint32_t context = numbers_.back();
      numbers_.pop_back();
      contexts_[context].is_queued = false;
      process(context);
    }
  }

  /// Reads the messages of a held context and works on it until no more come, then releases it. `read` takes a message
  /// and frees its memory.
  template <typename Read, typename Process, typename HasEnded>
  void work_on(std::uint32_t context, Read&& read, Process&& process, HasEnded&& has_ended) {
    auto& self = contexts_[context];
    for (;;) {
      QueuedMessage* waiting = self.mailbox.empty();
      while (waiting != nullptr) {
        QueuedMessage* const next = waiting->next;
        read(waiting);
        waiting = next;
      }
      process(context);
      self.owner.store(0, std::memory_order_relaxed);
      if (has_ended() || self.mailbox.rest()) break;
      self.owner.store(rank_, std::memory_order_relaxed);  // a message has come
    }
  }

 private:
  void own(std::uint32_t context) {
    contexts_[context].owner.store(rank_, std::memory_order_relaxed);
    numbers_.push_back(context);
  }

  Store& contexts_;
  std::uint8_t rank_;
  bool is_parallel_ = false;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace geminga::el

#endif
