// The flags that geminga-publish and geminga-subscribe share, and the stream that they describe.
#ifndef GEMINGA_SHELL_EVENT_OPTIONS_HPP
#define GEMINGA_SHELL_EVENT_OPTIONS_HPP

#include <CLI/App.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "geminga/service.hpp"
#include "shell/command_queue.hpp"
#include "shell/event_printer.hpp"
#include "shell/options.hpp"
#include "shell/stream.hpp"

namespace geminga::shell {

struct EventOptions {
  CommonOptions common;
  IdentityOptions identity;
  std::optional<ChannelMode> mode;
  std::string name;  ///< of this peer
  bool is_kept = false;
  bool has_timestamps = false;
  std::string command;  ///< run for each event; empty: none
  std::optional<double> command_seconds;

  explicit EventOptions(std::string_view program) : name(program) {}

  /// Adds the flags to the program. Borrows this for the life of `app`.
  void add_to(CLI::App& app, const std::string& timeout_meaning, const std::string& keep_meaning);
  [[nodiscard]] ChannelMode mode_or_stream() const { return mode.value_or(ChannelMode::one_to_many_stream); }
  /// The queue that runs the command; null where there is none. `program` must live as long as the queue.
  [[nodiscard]] std::unique_ptr<CommandQueue> commands(std::string_view program) const;
  /// Borrows `commands` for the life of the printer.
  [[nodiscard]] PrinterOptions printer(CommandQueue* commands) const {
    return {common.is_json, has_timestamps, commands};
  }
  /// A stream with these flags, whose `begin` is left to the caller. `program` and `commands` (null: none) must live as
  /// long as the stream.
  [[nodiscard]] Stream stream(std::string_view program, CommandQueue* commands) const;
};

}  // namespace geminga::shell

#endif
