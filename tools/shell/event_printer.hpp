// Prints events as lines or as JSON, or gives them to a command. Remembers earlier events, so that changes and
// departures can be described.
#ifndef GEMINGA_SHELL_EVENT_PRINTER_HPP
#define GEMINGA_SHELL_EVENT_PRINTER_HPP

#include <algorithm>
#include <boost/json/object.hpp>
#include <cstdint>
#include <iostream>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "geminga/event.hpp"
#include "shell/changes.hpp"
#include "shell/command_queue.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/stream.hpp"
#include "shell/terminal.hpp"
#include "shell/timestamp.hpp"

namespace geminga::shell {

/// The reason of a departure when the daemon went and, back again, did not report the service or request again.
inline constexpr std::string_view unconfirmed = "unconfirmed";

[[nodiscard]] inline const ServiceKey& key_of(const ServiceEvent& event) { return event.service; }
[[nodiscard]] inline const ServiceKey& key_of(const ConsumerEvent& event) { return event.subscription; }

struct PrinterOptions {
  bool is_json = false;
  bool has_timestamps = false;       ///< lines begin with the time; objects always have it
  CommandQueue* commands = nullptr;  ///< takes the events instead of standard output; borrowed, null: none
};

/// Told is ServiceEvent or ConsumerEvent. Events go to standard output, errors to standard error. Not thread-safe.
template <typename Told>
class EventPrinter final : public EventView {
 public:
  EventPrinter(std::string_view program, PrinterOptions options) : program_(program), options_(options) {}

  bool tell(const Event& event) override {
    if (const auto* error = std::get_if<Error>(&event.what)) {
      complain(program_, error->text);
      return false;
    }
    const auto* told = std::get_if<Told>(&event.what);
    if (told == nullptr) return false;
    tell({event.request, to_string(key_of(*told))}, *told);
    return true;
  }

  void doubt() override {
    for (auto& [key, known] : known_) known.is_in_doubt = true;
  }

  bool drop_doubted() override {
    const auto found = std::ranges::find_if(known_, [](const auto& entry) { return entry.second.is_in_doubt; });
    if (found == known_.end()) return false;
    Told gone = found->second.told;
    gone.change = Change::del;
    gone.reason = unconfirmed;
    tell(Key(found->first), gone);
    return true;
  }

 private:
  using Key = std::pair<std::uint32_t, std::string>;  ///< the request, and the key of the service or subscription
  struct Known {
    Told told;
    bool is_in_doubt = false;
  };

  void tell(const Key& key, const Told& told) {
    const auto known = known_.find(key);
    const Told* before = known == known_.end() ? nullptr : &known->second.told;
    if (options_.commands != nullptr) {
      options_.commands->add(stamped(object(told, before)));
    } else if (options_.is_json) {
      shell::print(std::cout, stamped(object(told, before)));
    } else {
      const std::string stamp = options_.has_timestamps ? timestamp() + ' ' : "";
      std::cout << stamp << printable(line(told, before)) << '\n' << std::flush;
    }
    if (told.change == Change::del) {
      known_.erase(key);
    } else {
      known_.insert_or_assign(key, Known{told});
    }
  }

  /// The fields that the earlier event had otherwise.
  static boost::json::object changed(const Told& told, const Told& before) {
    auto object = to_json(before);
    object["event"] = to_string(told.change);
    return former(object, to_json(told));
  }

  static boost::json::object object(const Told& told, const Told* before) {
    auto object = to_json(told);
    if (before == nullptr) return object;
    if (told.change == Change::modify) object["former"] = changed(told, *before);
    if (told.change == Change::del) {
      // The daemon reports only the key of what is gone.
      for (const auto& member : to_json(*before)) object.insert(member);
    }
    return object;
  }

  static std::string line(const Told& told, const Told* before) {
    if (told.change == Change::del)
      return gone_line(before == nullptr ? "" : name_of(*before), key_of(told), told.reason);
    std::string line = line_of(told);
    if (told.change != Change::modify || before == nullptr) return line;
    const std::string words = words_of(changed(told, *before));
    return words.empty() ? line : line + "  (" + words + ')';
  }

  std::string_view program_;
  PrinterOptions options_;
  std::map<Key, Known> known_;  ///< the last event of each service or request that is not gone
};

}  // namespace geminga::shell

#endif
