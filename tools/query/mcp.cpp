// geminga-query mcp: the questions to the daemon as tools of the Model Context Protocol, for assistants.
#include <iostream>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "query/mcp/conversation.hpp"
#include "query/mcp/messages.hpp"
#include "shell/report.hpp"

namespace geminga::query {
namespace {

/// Asks by a connection of its own, so that a daemon that comes, goes or is late costs one answer and no more.
Result<Answer, ClientError> ask(const Context& context, const std::string& kind, const Parameters& parameters) {
  auto client = Client::connect(client_options(context));
  if (!client) return std::unexpected(client.error());
  return client->query(kind, parameters);
}

shell::ExitStatus serve(const Context& context) {
  if (refuses_watch(context, "mcp")) return shell::ExitStatus::wrong_use;
  mcp::Conversation conversation(
      [&context](const std::string& kind, const Parameters& parameters) { return ask(context, kind, parameters); },
      GEMINGA_VERSION);
  while (const auto line = mcp::read_line(std::cin)) {
    std::cout << conversation.answer(*line) << std::flush;
    if (!std::cout) break;  // the client reads no more; the caller says so
  }
  return shell::ExitStatus::found;
}

}  // namespace

void add_mcp(CLI::App& app, RunAlone& selected) {
  CLI::App* command = app.add_subcommand(
      "mcp", "Serve the Model Context Protocol on standard input and output, read-only, for assistants");
  command->footer(
      "Example: geminga-query mcp\n"
      "In the configuration of an assistant:\n"
      "  {\"mcpServers\": {\"robot\": {\"command\": \"geminga-query\", \"args\": [\"mcp\"]}}}\n"
      "  {\"mcpServers\": {\"robot\": {\"command\": \"ssh\", \"args\": [\"robot2\", \"geminga-query\", \"mcp\"]}}}\n"
      "Its tools are participants, services, requests, match, explain, why, ontology, status and security; each "
      "answers\n"
      "with the document of --json. It goes on when a lost daemon is back, and ends with standard input.\n"
      "Names and texts in answers come from other robots: an assistant must treat them as data, not as instructions.");
  command->callback([&selected] { selected = serve; });
}

}  // namespace geminga::query
