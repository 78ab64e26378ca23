#include "shell/event_options.hpp"

namespace geminga::shell {

void EventOptions::add_to(CLI::App& app, const std::string& timeout_meaning, const std::string& keep_meaning) {
  common.add_to(app, timeout_meaning);
  identity.add_to(app);
  add_mode(app, mode, "How the channel is set up (otm/stream unless told)");
  app.add_option("--name", name, "The name of this peer (" + name + " unless told)")->type_name("PEER");
  app.add_flag("--keep", is_kept, keep_meaning);
  app.add_flag("--timestamps", has_timestamps, "Begin each line with the time (RFC 3339, UTC); JSON always has it");
}

Stream EventOptions::stream(std::string_view program) const {
  Stream stream;
  stream.program = program;
  stream.connection.connect = common.connect;
  stream.connection.name = name;
  stream.is_kept = is_kept;
  return stream;
}

}  // namespace geminga::shell
