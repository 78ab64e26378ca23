// Nodes on an executor of Boost.Asio: sending, receiving and events with any completion token, coroutines included.
#ifndef GEMINGA_ASIO_HPP
#define GEMINGA_ASIO_HPP

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/associated_cancellation_slot.hpp>
#include <boost/asio/associated_executor.hpp>
#include <boost/asio/async_result.hpp>
#include <boost/asio/dispatch.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/system/error_code.hpp>
#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "geminga/node.hpp"

namespace geminga {

/// A node that an executor drives: no call waits, no thread is started, and the program does not call process(). All of
/// it happens on that executor, which has to be a strand if several threads run it. Publishers and subscribers must end
/// before it. Neither copies nor moves.
///
/// Each operation completes with a boost::system::error_code first: operation_aborted where it was cancelled, by the
/// token's cancellation slot, by cancel() or by the end of the node, and eof where the publisher or subscriber has
/// ended.
class AsioNode {
 public:
  using executor_type = boost::asio::any_io_executor;
  using error_code = boost::system::error_code;

  /// Takes a node over.
  AsioNode(executor_type executor, Node node) : state_(std::make_shared<State>(std::move(executor), std::move(node))) {
    state_->drive(state_);
  }
  ~AsioNode() { state_->stop(); }
  AsioNode(const AsioNode&) = delete;
  AsioNode& operator=(const AsioNode&) = delete;

  [[nodiscard]] executor_type get_executor() const { return state_->ready.get_executor(); }
  /// The node, for calls that do not wait: publish() and subscribe() with Wait::for_nothing, begin_close().
  [[nodiscard]] Node& node() { return state_->node; }

  /// The next event: `void(error_code, std::optional<ChannelEvent>)`.
  template <typename Token>
  auto async_event(Token&& token) {
    return wait<std::optional<ChannelEvent>>([state = state_.get()](error_code&) { return state->node.next_event(); },
                                             std::forward<Token>(token));
  }
  /// The next message: `void(error_code, std::optional<Message>)`.
  template <typename Token>
  auto async_receive(Subscriber& subscriber, Token&& token) {
    return wait<std::optional<Message>>(
        [&subscriber](error_code& error) {
          auto message = subscriber.poll();
          if (!message && subscriber.has_ended()) error = boost::asio::error::eof;
          return message;
        },
        std::forward<Token>(token));
  }
  /// Sends as soon as every consumer has room: `void(error_code, bool)`, true if it was sent. `payload` must live until
  /// then. The error message_size is a payload over the limit of the protocol.
  template <typename Token>
  auto async_send(Publisher& publisher, std::span<const std::byte> payload, Token&& token) {
    return wait<std::optional<bool>>(
        [&publisher, payload](error_code& error) -> std::optional<bool> {
          if (!publisher.has_room(payload.size())) return std::nullopt;
          const auto sent = publisher.send(payload);
          if (!sent && sent.error().kind == SendError::Kind::too_large) error = boost::asio::error::message_size;
          if (!sent && sent.error().kind == SendError::Kind::closed) error = boost::asio::error::eof;
          return sent.has_value();
        },
        std::forward<Token>(token));
  }
  template <typename Token>
  auto async_send(Publisher& publisher, std::string_view payload, Token&& token) {
    return async_send(publisher, std::as_bytes(std::span(payload.data(), payload.size())), std::forward<Token>(token));
  }
  /// Withdraws everything cleanly: `void(error_code, std::optional<bool>)`.
  template <typename Token>
  auto async_close(Token&& token) {
    state_->node.begin_close();
    return wait<std::optional<bool>>(
        [state = state_.get()](error_code&) { return state->node.has_ended() ? std::optional(true) : std::nullopt; },
        std::forward<Token>(token));
  }
  /// Ends all operations that wait.
  void cancel() { state_->cancel_all(); }

 private:
  /// An operation that waits: `attempt` is called whenever something has come, and returns true when it is over.
  struct Waiting {
    std::function<bool()> attempt;
    std::function<void()> cancel;
  };

  class State {
   public:
    State(executor_type executor, Node taken) : node(std::move(taken)), ready(std::move(executor), node.descriptor()) {}
    ~State() { ready.release(); }  // the descriptor is the node's

    static void drive(const std::shared_ptr<State>& self) {
      if (self->is_stopped) return;
      self->ready.async_wait(boost::asio::posix::stream_descriptor::wait_read, [self](error_code error) {
        if (error || self->is_stopped) return;
        self->node.process();
        self->attempt_all();
        drive(self);
      });
    }
    void attempt_all() {
      // Handlers are called later, so that no operation begins meanwhile.
      waiting.remove_if([](const std::shared_ptr<Waiting>& one) { return one->attempt(); });
    }
    void cancel_all() {
      for (const auto& one : std::exchange(waiting, {})) one->cancel();
    }
    void stop() {
      is_stopped = true;
      cancel_all();
      error_code ignored;
      ready.cancel(ignored);
    }

    Node node;
    boost::asio::posix::stream_descriptor ready;
    std::list<std::shared_ptr<Waiting>> waiting;
    bool is_stopped = false;
  };

  /// Waits until `attempt` gives something or sets its error.
  template <typename Value, typename Attempt, typename Token>
  auto wait(Attempt attempt, Token&& token) {
    return boost::asio::async_initiate<Token, void(error_code, Value)>(
        [state = state_](auto handler, Attempt given) {
          using Handler = decltype(handler);
          const auto shared = std::make_shared<Handler>(std::move(handler));
          const auto complete = [state, shared](error_code error, Value value) {
            auto executor = boost::asio::get_associated_executor(*shared, state->ready.get_executor());
            boost::asio::post(executor, [shared, error, value = std::move(value)]() mutable {
              std::move (*shared)(error, std::move(value));
            });
          };
          const auto one = std::make_shared<Waiting>();
          one->attempt = [given = std::move(given), complete]() mutable {
            error_code error;
            Value value = given(error);
            if (!value && !error) return false;
            complete(error, std::move(value));
            return true;
          };
          one->cancel = [complete] { complete(boost::asio::error::operation_aborted, Value{}); };
          if (state->is_stopped) return one->cancel();
          state->node.process();
          if (one->attempt()) return state->attempt_all();
          state->waiting.push_back(one);
          state->attempt_all();
          auto slot = boost::asio::get_associated_cancellation_slot(*shared);
          if (!slot.is_connected()) return;
          slot.assign([state, weak = std::weak_ptr(one)](boost::asio::cancellation_type) {
            const auto waiting = weak.lock();
            if (!waiting || std::erase(state->waiting, waiting) == 0) return;
            waiting->cancel();
          });
        },
        token, std::move(attempt));
  }

  std::shared_ptr<State> state_;
};

}  // namespace geminga

#endif
