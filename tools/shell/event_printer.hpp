// Prints the events of one kind as lines for a reader or as JSON, and remembers who is there so that a line that says
// "gone" can name it.
#ifndef GEMINGA_SHELL_EVENT_PRINTER_HPP
#define GEMINGA_SHELL_EVENT_PRINTER_HPP

#include <iostream>
#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "geminga/event.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/terminal.hpp"

namespace geminga::shell {

[[nodiscard]] inline const ServiceKey& key_of(const ServiceEvent& event) { return event.service; }
[[nodiscard]] inline const ServiceKey& key_of(const ConsumerEvent& event) { return event.subscription; }

/// Told is ServiceEvent or ConsumerEvent. Not thread-safe.
template <typename Told>
class EventPrinter {
 public:
  EventPrinter(std::string_view program, bool is_json) : program_(program), is_json_(is_json) {}

  /// Prints one event on standard output, an error on standard error. Returns whether it was an event of this kind.
  bool print(const Event& event) {
    if (const auto* error = std::get_if<Error>(&event.what)) {
      complain(program_, error->text);
      return false;
    }
    const auto* told = std::get_if<Told>(&event.what);
    if (told == nullptr) return false;
    if (is_json_) {
      shell::print(std::cout, to_json(*told));
    } else {
      std::cout << printable(line(*told)) << std::endl;
    }
    return true;
  }

 private:
  std::string line(const Told& told) {
    if (told.change != Change::del) {
      names_[to_string(key_of(told))] = name_of(told);
      return line_of(told);
    }
    // The daemon says nothing but the key of what is gone.
    const auto known = names_.extract(to_string(key_of(told)));
    return gone_line(known.empty() ? "" : known.mapped(), key_of(told), told.reason);
  }

  std::string_view program_;
  bool is_json_;
  std::map<std::string, std::string> names_;  ///< of what is there, by its key
};

}  // namespace geminga::shell

#endif
