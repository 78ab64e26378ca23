// geminga-subscribe: asks for services from a shell and prints the events.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <vector>

#include "geminga/client.hpp"
#include "shell/event_options.hpp"
#include "shell/event_printer.hpp"
#include "shell/event_variables.hpp"
#include "shell/options.hpp"
#include "shell/pipe.hpp"
#include "shell/stream.hpp"
#include "shell/whole_lines.hpp"

namespace geminga::subscribe {
namespace {

constexpr std::string_view program = "geminga-subscribe";

constexpr const char* examples = R"(Examples:
  geminga-subscribe soccer:TrackedObject
  geminga-subscribe soccer:BallInfo --representation soccer:CartesianFieldFrame --where 'rate >= 30'
  geminga-subscribe --text camera --mode otm/pubsub --provider robot2,robot3/vision
  geminga-subscribe soccer:BallInfo --count 1 --timeout 5 --json
  geminga-subscribe soccer:TrackedObject --keep --timestamps
  geminga-subscribe soccer:BallInfo --mode otm/pubsub --listen
  geminga-subscribe --text map --mode oto --exec 'echo "$GEMINGA_EVENT $GEMINGA_NAME $GEMINGA_ADDRESS:$GEMINGA_PORT"'

Prints each event as a line: + a service is there, ~ it changed (with the former values), - it is gone (with the reason). With
--keep it waits for a lost daemon and asks again: services that are still there are printed again, the others as gone (unconfirmed).

Exit status: 0 ended by a signal, after --count events, or by --timeout when something was printed and no --count is given; 2 wrong
usage (also a name that the daemon's ontology does not know); 3 the daemon is gone; 4 ended by --timeout otherwise.

)";

struct Options {
  shell::EventOptions shared{program};
  std::vector<std::string> concepts;
  NamedSubscription subscription;  ///< without its identity
  std::vector<NamedIdentity> identities;
  std::vector<std::string> providers;
  std::vector<std::string> favoured;
  std::optional<std::uint32_t> limit;
  std::uint64_t count = 0;
  bool listens = false;
};

/// The cost in a word of --convert. Throws CLI::ValidationError.
std::uint32_t accepted_cost(const std::string& word) {
  if (word == "yes") return any_cost;
  if (word == "no") return 0;
  std::uint32_t cost = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), cost);
  if (error != std::errc() || end != word.data() + word.size()) {
    throw CLI::ValidationError("--convert", "must be yes, no or the largest cost, a whole number from 0 to 4294967295");
  }
  return cost;
}

void add_to(CLI::App& app, Options& options) {
  app.add_option("CONCEPT", options.concepts,
                 "prefix:Name, <IRI>, a label or a class expression; several are asked for together");
  options.shared.add_to(app, "End after this time (default: never)", "When the daemon goes, wait for it and ask again");
  shell::add_degree(app, options.subscription.weakest);
  app.add_option("--where", options.subscription.where, "Only services whose attributes fulfil this condition")
      ->type_name("EXPRESSION");
  app.add_option("--limit", options.limit, "At most this many providers, the best; 0: all (1 for oto, else all)")
      ->type_name("K")
      ->check(shell::whole_number(0, UINT32_MAX), "", "");
  app.add_option("--provider", options.providers, "Only these providers, with commas or given several times")
      ->type_name("PARTICIPANT[/PEER]")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--protocol", options.subscription.protocols,
                 "Only services with one of these protocols, with commas or given several times")
      ->type_name("P")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--scope", options.subscription.scope, "Only services on these hosts: host, any, HOST[/PEER], !HOST")
      ->type_name("SCOPE");
  app.add_option("--on", options.subscription.on,
                 "Only on robots that are known to be this by their descriptions: a class or a class expression")
      ->type_name("EXPRESSION");
  app.add_option("--favour", options.favoured, "First these providers, in this order, then all others")
      ->type_name("PARTICIPANT[/PEER]")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--prefer", options.subscription.prefer,
                 "First those whose attributes are best, e.g. 'accuracy asc by 5 cm, rate desc'")
      ->type_name("WISHES");
  app.add_option("--rank", options.subscription.rank,
                 "By what providers are ranked first: favour, priority, prefer, degree, distance, with commas")
      ->type_name("CRITERIA");
  app.add_option_function<std::string>(
         "--convert", [&options](const std::string& word) { options.subscription.convert = accepted_cost(word); },
         "Also services whose representation can be converted: yes, no or the largest cost")
      ->type_name("yes|no|COST");
  app.add_option_function<std::string>(
         "--reach", [&options](const std::string& word) { options.subscription.reach = *required_reach(word); },
         "any: also services whose address cannot be reached from this host (routed)")
      ->type_name("routed|any")
      ->check(CLI::IsMember({"routed", "any"}), "", "");
  app.add_option("--priority", options.subscription.priority, "Told to the provider")
      ->type_name("K")
      ->check(shell::whole_number(INT32_MIN, INT32_MAX), "", "");
  app.add_option("--port", options.subscription.port, "Where this consumer can be reached; told to the provider")
      ->type_name("1..65535")
      ->check(shell::whole_number(1, 65535), "", "");
  app.add_option("--address", options.subscription.address, "Its IP address; told to the provider");
  app.add_flag("--listen", options.listens,
               "Receive from the services, and print each message as a line instead of the events")
      ->excludes("--json", "--timestamps", "--exec", "--convert");
  app.add_option("--count", options.count, "End after this many events, or messages; 0: never")
      ->type_name("N")
      ->check(shell::whole_number(0, 1'000'000'000'000'000), "", "");
}

/// The providers in the words of a flag. Throws CLI::ValidationError.
std::vector<ProviderFilter> providers_of(const std::string& flag, const std::vector<std::string>& words) {
  std::vector<ProviderFilter> providers;
  for (const auto& word : words) {
    const auto slash = word.find('/');
    const std::string participant = word.substr(0, slash);
    if (participant.empty()) throw CLI::ValidationError(flag, "must be PARTICIPANT or PARTICIPANT/PEER");
    providers.push_back({participant, slash == std::string::npos ? "" : word.substr(slash + 1)});
  }
  return providers;
}

/// Reads the positional words and checks the flags together. Throws CLI::ValidationError.
void complete(Options& options) {
  std::erase_if(options.concepts, [&](const auto& word) { return options.shared.identity.takes(word); });
  for (auto& concept_name : options.concepts) {
    const auto pair = shell::key_and_value(concept_name);
    if (pair && pair->first != "concept") {
      throw CLI::ValidationError(concept_name, "is no concept: attributes are asked for with --where '" + pair->first +
                                                   " = " + pair->second + "'");
    }
    if (pair) concept_name = pair->second;
    const auto identity = options.shared.identity.identity(concept_name);
    if (!identity || concept_name.empty()) throw CLI::ValidationError("CONCEPT", "must not be empty");
    options.identities.push_back(*identity);
  }
  if (options.concepts.empty()) {
    auto identity = options.shared.identity.identity("");
    if (!identity) throw CLI::ValidationError("IDENTITY", "is missing: name a CONCEPT, --id N or --text NAME");
    options.identities.push_back(std::move(*identity));
  }
  const auto carries = [](const std::string& protocol) { return protocol == "udp" || protocol == "tcp"; };
  if (options.listens && !std::ranges::all_of(options.subscription.protocols, carries)) {
    throw CLI::ValidationError("--protocol", "must be udp or tcp where --listen receives");
  }
  options.subscription.mode = options.shared.mode_or_stream();
  options.subscription.limit = options.limit;
  options.subscription.providers = providers_of("--provider", options.providers);
  options.subscription.favoured = providers_of("--favour", options.favoured);
}

std::vector<NamedSubscription> subscriptions_of(const Options& options) {
  std::vector<NamedSubscription> subscriptions;
  for (const auto& identity : options.identities) {
    subscriptions.push_back(options.subscription);
    subscriptions.back().identity = identity;
  }
  return subscriptions;
}

std::expected<void, ClientError> begin(const Options& options, Client& client) {
  for (const auto& subscription : subscriptions_of(options)) {
    if (const auto request = client.subscribe(subscription); !request) return std::unexpected(request.error());
  }
  return {};
}

int run(int argc, char** argv) {
  CLI::App app("Asks for services and prints the events: what is there, what changes, what is gone.",
               std::string(program));
  app.footer(std::string(examples) + std::string(shell::exec_words));
  Options options;
  add_to(app, options);
  app.callback([&options] { complete(options); });
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);

  const auto commands = options.shared.commands(program);
  shell::EventPrinter<ServiceEvent> printer(program, options.shared.printer(commands.get()));
  shell::Stream stream = options.shared.stream(program, commands.get());
  if (options.shared.common.timeout_seconds) {
    stream.timeout = options.shared.common.timeout_or({});
    // A daemon that accepts and does not answer delays the program no longer than --timeout.
    stream.connection.timeout = std::min(stream.connection.timeout, *stream.timeout);
  }
  stream.count = options.count;
  if (options.listens) {
    return static_cast<int>(shell::listen({program, stream.connection, stream.timeout, options.count, stream.is_kept},
                                          subscriptions_of(options)));
  }
  stream.begin = [&options](Client& client) { return begin(options, client); };
  return static_cast<int>(shell::run(stream, printer));
}

}  // namespace
}  // namespace geminga::subscribe

int main(int argc, char** argv) {
  const geminga::shell::WholeLines lines;
  return geminga::subscribe::run(argc, argv);
}
