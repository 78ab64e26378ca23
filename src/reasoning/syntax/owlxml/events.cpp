#include "reasoning/syntax/owlxml/events.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "base/parallel/crew.hpp"
#include "base/parallel/room.hpp"

namespace geminga::owlxml {
namespace {

/// Copies the events of a walk into the queue.
class Recorder final : public Listener {
 public:
  explicit Recorder(EventQueue& queue) : queue_(queue) {}

  Refusal begin(std::string_view space, std::string_view name, std::span<const Attribute> attributes,
                std::uint32_t line) override {
    std::size_t bytes = 0;
    for (const Attribute& attribute : attributes) bytes += attribute.value.size();
    if (!make_room(bytes)) return stopped();
    events_->begin(space, name, attributes, line);
    return std::nullopt;
  }
  Refusal text(std::string_view part, std::uint32_t line) override {
    if (!make_room(part.size())) return stopped();
    events_->text(part, line);
    return std::nullopt;
  }
  Refusal end(std::uint32_t line) override {
    if (!make_room(0)) return stopped();
    events_->end(line);
    return std::nullopt;
  }
  void finish() override {
    if (events_ != nullptr && !events_->is_empty()) queue_.put(std::move(events_));
    queue_.close();
  }

 private:
  /// False where nobody listens any more.
  bool make_room(std::size_t bytes) {
    if (events_ != nullptr && events_->has_room(bytes)) return true;
    if (events_ != nullptr) queue_.put(std::move(events_));
    events_ = queue_.empty();
    if (events_ != nullptr) events_->clear(bytes);
    return events_ != nullptr;
  }

  /// The words are never shown: the other thread has the problem.
  static Refusal stopped() { return "is read no further"; }

  EventQueue& queue_;
  std::unique_ptr<Events> events_;
};

std::optional<Problem> tell_all(EventQueue& queue, Listener& listener) {
  try {
    while (auto events = queue.take()) {
      if (auto problem = events->tell(listener)) return problem;
      queue.give_back(std::move(events));
    }
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    return Problem{0, "needs more memory than there is"};
  }
}

}  // namespace

Events::Events() { events_.reserve(max_events); }

void Events::clear(std::size_t bytes) {
  events_.clear();
  attributes_.clear();
  if (bytes > size_ || size_ == 0) {
    size_ = std::max(bytes, usual_bytes);
    bytes_ = std::make_unique_for_overwrite<char[]>(size_);
  }
  next_ = bytes_.get();
  left_ = size_;
}

std::string_view Events::copy_of(std::string_view text) {
  const std::string_view copy(next_, text.size());
  std::ranges::copy(text, next_);
  next_ += text.size();
  left_ -= text.size();
  return copy;
}

void Events::begin(std::string_view space, std::string_view name, std::span<const Attribute> attributes,
                   std::uint32_t line) {
  events_.push_back({Kind::begin, line, space, name, attributes_.size(), attributes.size()});
  for (const Attribute& attribute : attributes)
    attributes_.push_back({attribute.space, attribute.name, copy_of(attribute.value)});
}

void Events::text(std::string_view part, std::uint32_t line) {
  events_.push_back({Kind::text, line, {}, copy_of(part), 0, 0});
}

void Events::end(std::uint32_t line) { events_.push_back({Kind::end, line, {}, {}, 0, 0}); }

std::optional<Problem> Events::tell(Listener& listener) const {
  const std::span<const Attribute> attributes(attributes_);
  for (const Event& event : events_) {
    Listener::Refusal refusal;
    switch (event.kind) {
      case Kind::begin:
        refusal = listener.begin(event.space, event.name, attributes.subspan(event.first, event.count), event.line);
        break;
      case Kind::text:
        refusal = listener.text(event.name, event.line);
        break;
      case Kind::end:
        refusal = listener.end(event.line);
        break;
    }
    if (refusal) return Problem{event.line, std::move(*refusal)};
  }
  return std::nullopt;
}

std::unique_ptr<Events> EventQueue::empty() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return is_stopped_ || untold_ < max_ahead; });
  if (is_stopped_) return nullptr;
  ++untold_;
  if (empty_.empty()) return std::make_unique<Events>();
  auto events = std::move(empty_.back());
  empty_.pop_back();
  return events;
}

void EventQueue::put(std::unique_ptr<Events> events) {
  const std::lock_guard lock(mutex_);
  full_.push(std::move(events));
  changed_.notify_all();
}

void EventQueue::close() {
  std::unique_lock lock(mutex_);
  is_closed_ = true;
  changed_.notify_all();
  changed_.wait(lock, [&] { return is_stopped_; });
}

std::unique_ptr<Events> EventQueue::take() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return is_stopped_ || is_closed_ || !full_.empty(); });
  if (is_stopped_ || full_.empty()) return nullptr;
  auto events = std::move(full_.front());
  full_.pop();
  return events;
}

void EventQueue::give_back(std::unique_ptr<Events> events) {
  const std::lock_guard lock(mutex_);
  --untold_;
  empty_.push_back(std::move(events));
  changed_.notify_all();
}

void EventQueue::stop() {
  const std::lock_guard lock(mutex_);
  is_stopped_ = true;
  changed_.notify_all();
}

std::optional<Problem> walk_apart(std::string_view bytes, const XmlLimits& limits, Listener& listener) {
  if (!parallel::has_room_for(1)) return walk(bytes, limits, listener);
  parallel::Crew crew(2);
  if (crew.size() == 1) return walk(bytes, limits, listener);
  EventQueue queue;
  std::optional<Problem> of_walk;
  std::optional<Problem> of_listener;
  const auto work = [&](unsigned me) {
    if (me != 0) {
      Recorder recorder(queue);
      of_walk = walk(bytes, limits, recorder);
      queue.close();
    } else {
      of_listener = tell_all(queue, listener);
      queue.stop();
    }
  };
  crew.run(work, [&] { queue.stop(); });
  return of_listener ? of_listener : of_walk;
}

}  // namespace geminga::owlxml
