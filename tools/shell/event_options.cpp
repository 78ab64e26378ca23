#include "shell/event_options.hpp"

namespace geminga::shell {

void EventOptions::add_to(CLI::App& app, const std::string& timeout_meaning, const std::string& keep_meaning) {
  common.add_to(app, timeout_meaning);
  identity.add_to(app);
  add_mode(app, mode, "How the channel is set up (default: otm/stream)");
  app.add_option("--name", name, "The name of this peer (default: " + name + ")")
      ->type_name("PEER")
      ->check([](const std::string& text) { return text.empty() ? "must not be empty" : ""; }, "", "");
  app.add_flag("--keep", is_kept, keep_meaning);
  app.add_flag("--timestamps", has_timestamps, "Begin each line with the time (RFC 3339, UTC); JSON always has it");
  auto* const exec =
      app.add_option("--exec", command, "Run this command once an event, instead of printing it; see below")
          ->type_name("COMMAND")
          ->excludes("--json", "--timestamps")
          ->check([](const std::string& text) { return text.empty() ? "must not be empty" : ""; }, "", "");
  add_seconds(app, "--exec-timeout", command_seconds,
              "How long the command may run before it is ended (default: 60; 0: for ever)")
      ->needs(exec);
}

std::unique_ptr<CommandQueue> EventOptions::commands(std::string_view program) const {
  if (command.empty()) return nullptr;
  CommandOptions options{.command = command, .connect = common.connect};
  if (command_seconds) options.time = in_milliseconds(*command_seconds);
  if (options.time == std::chrono::milliseconds(0)) options.time.reset();
  return std::make_unique<CommandQueue>(program, std::move(options));
}

Stream EventOptions::stream(std::string_view program, CommandQueue* commands) const {
  Stream stream;
  stream.program = program;
  stream.connection.connect = common.connect;
  stream.connection.name = name;
  stream.is_kept = is_kept;
  stream.commands = commands;
  return stream;
}

}  // namespace geminga::shell
