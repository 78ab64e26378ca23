// The events of a walk over a file, copied, so that one thread walks while another builds axioms of what it has seen.
#ifndef GEMINGA_REASONING_SYNTAX_OWLXML_EVENTS_HPP
#define GEMINGA_REASONING_SYNTAX_OWLXML_EVENTS_HPP

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <queue>
#include <span>
#include <string_view>
#include <vector>

#include "reasoning/syntax/owlxml/elements.hpp"

namespace geminga::owlxml {

/// Events that follow each other. Names of elements and attributes are the walk's own; values and texts are copies.
class Events {
 public:
  Events();

  /// Empties it, and makes room for a value or text of this size.
  void clear(std::size_t bytes);
  /// Whether there is room for one more event with so many octets.
  [[nodiscard]] bool has_room(std::size_t bytes) const { return events_.size() < max_events && bytes <= left_; }
  [[nodiscard]] bool is_empty() const { return events_.empty(); }

  /// Each requires room.
  void begin(std::string_view space, std::string_view name, std::span<const Attribute> attributes, std::uint32_t line);
  void text(std::string_view part, std::uint32_t line);
  void end(std::uint32_t line);

  /// Tells a listener all of them, up to the first that it refuses.
  [[nodiscard]] std::optional<Problem> tell(Listener& listener) const;

 private:
  static constexpr std::size_t max_events = 2048;
  static constexpr std::size_t usual_bytes = std::size_t{1} << 16;

  enum class Kind : std::uint8_t { begin, text, end };
  struct Event {
    Kind kind = Kind::end;
    std::uint32_t line = 0;
    std::string_view space;
    std::string_view name;  ///< or the text
    std::size_t first = 0;  ///< of its attributes
    std::size_t count = 0;  ///< of its attributes
  };

  std::string_view copy_of(std::string_view text);

  std::vector<Event> events_;
  std::vector<Attribute> attributes_;
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;  ///< of bytes_
  char* next_ = nullptr;  ///< the first of them that is free
  std::size_t left_ = 0;  ///< from there
};

/// Hands events from the thread that walks to the one that builds, a few of them at a time.
class EventQueue {
 public:
  /// Events to fill; waits while many are not told yet. None once the queue was stopped.
  [[nodiscard]] std::unique_ptr<Events> empty();
  void put(std::unique_ptr<Events> events);
  /// Says that no more will be put, and waits until all have been told or the queue is stopped.
  void close();

  /// The next events; waits for them. None where there are no more.
  [[nodiscard]] std::unique_ptr<Events> take();
  void give_back(std::unique_ptr<Events> events);
  /// Says that no more will be taken.
  void stop();

 private:
  static constexpr std::size_t max_ahead = 16;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::queue<std::unique_ptr<Events>> full_;
  std::vector<std::unique_ptr<Events>> empty_;
  std::size_t untold_ = 0;  ///< handed out to be filled, and not given back
  bool is_closed_ = false;
  bool is_stopped_ = false;
};

/// Walks over a file in a thread of its own while the caller's tells the listener. The result is that of walk(), which
/// it calls where there is no second thread.
[[nodiscard]] std::optional<Problem> walk_apart(std::string_view bytes, const XmlLimits& limits, Listener& listener);

}  // namespace geminga::owlxml

#endif
