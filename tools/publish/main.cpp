// geminga-publish: offers one service from a shell until it is ended.
#include <CLI/CLI.hpp>
#include <boost/json/object.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "geminga/attribute.hpp"
#include "geminga/client.hpp"
#include "shell/describe.hpp"
#include "shell/event_options.hpp"
#include "shell/event_printer.hpp"
#include "shell/event_variables.hpp"
#include "shell/json.hpp"
#include "shell/options.hpp"
#include "shell/pipe.hpp"
#include "shell/stream.hpp"
#include "shell/terminal.hpp"
#include "shell/whole_lines.hpp"

namespace geminga::publish {
namespace {

constexpr std::string_view program = "geminga-publish";

constexpr const char* examples = R"(Examples:
  geminga-publish soccer:BallInfo --representation soccer:CartesianFieldFrame --mode otm/stream --port 5000
  geminga-publish --text camera --mode otm/pubsub --port 5001 --priority 5 rate=30 frame=front
  geminga-publish --id 0x1234 --mode oto --port 5002 --protocol tcp --json
  geminga-publish --text frames --mode oto --port 5003 --converts 'soccer:PolarRobotFrame>soccer:PolarFieldFrame' cost=3
  tail -f positions | geminga-publish soccer:BallInfo --mode otm/pubsub --send
  geminga-publish --text lamp --mode oto --port 5003 --exec 'echo "$GEMINGA_EVENT by $GEMINGA_NAME"'

Offers the service until Ctrl-C or a SIGTERM, and prints its consumers when they come (+), change (~, with the former values)
and go (-, with the reason). With --keep it waits for a lost daemon and offers the service again: consumers that are still there
are printed again, the others as gone (unconfirmed).

Exit status: 0 ended by a signal, 2 wrong usage (also a name that the daemon's ontology does not know), 3 the daemon is gone.

)";

const std::string converts = "converts";

struct Options {
  shell::EventOptions shared{program};
  std::vector<std::string> words;
  std::vector<std::string> attributes;
  NamedPublication publication;
  std::string converts;
  bool sends = false;
};

/// The error in the value of `converts`; empty: none.
std::string conversion_fault(const std::string& text) {
  return text.find('>', 1) == std::string::npos ? "must be FROM>TO" : "";
}

void add_to(CLI::App& app, Options& options) {
  app.add_option(
      "WORDS", options.words,
      "The CONCEPT (prefix:Name, <IRI>, a label or a class expression; left out with --id or --text), then attributes "
      "KEY=VALUE");
  options.shared.add_to(app, "How long to wait for the daemon (default: 5)",
                        "When the daemon goes, wait for it and offer again");
  app.add_option("--port", options.publication.port, "Where the service can be reached")
      ->type_name("1..65535")
      ->check(shell::whole_number(1, 65535), "", "");
  app.add_flag(
         "--send", options.sends,
         "Send each line of standard input as a message to the consumers; default port: any. A line has at most 65000 "
         "octets, with --protocol tcp 16 MiB")
      ->excludes("--json", "--timestamps", "--exec");
  app.add_option("--address", options.publication.address,
                 "The IP address of the service (default: each interface's own)");
  app.add_option("--protocol", options.publication.protocol, "How messages are carried (default: udp)");
  app.add_option(
         "--attribute", options.attributes,
         "An attribute, also one whose name is near a key: as the word attr.KEY=VALUE; may be given several times")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option("--converts", options.converts,
                 "The service converts one representation into another; the attribute cost states the cost")
      ->type_name("FROM>TO")
      ->check(conversion_fault, "", "");
  app.add_option("--scope", options.publication.scope, "Only consumers on these hosts: host, any, HOST[/PEER], !HOST")
      ->type_name("SCOPE");
  app.add_option("--for", options.publication.for_whom, "Only consumers that fit, e.g. \"name = robot*\"")
      ->type_name("EXPRESSION");
  app.add_option("--priority", options.publication.priority,
                 "Where several providers match, the greatest wins (default: 0)")
      ->type_name("K")
      ->check(shell::whole_number(INT32_MIN, INT32_MAX), "", "");
}

/// Adds the attribute of a word NAME=VALUE. Throws CLI::ValidationError.
void add_attribute(Attributes& attributes, const std::string& word, const std::string& name) {
  const auto equals = word.find('=');
  if (name.empty() || equals == std::string::npos) {
    throw CLI::ValidationError(word, "is no attribute: write KEY=VALUE");
  }
  if (!attributes.emplace(name, word.substr(equals + 1)).second) {
    throw CLI::ValidationError(name, "is given twice: give each attribute once");
  }
}

/// Reads the positional words and checks the flags together. Throws CLI::ValidationError.
void complete(Options& options) {
  std::erase_if(options.words, [&](const auto& word) { return options.shared.identity.takes(word); });
  auto word = options.words.begin();
  std::string concept_name;
  if (!options.shared.identity.needs_no_concept() && word != options.words.end()) {
    const auto pair = shell::key_and_value(*word);
    if (!pair || pair->first == "concept") concept_name = pair ? pair->second : *word;
    if (!concept_name.empty()) ++word;
  }
  auto identity = options.shared.identity.identity(concept_name);
  if (!identity) throw CLI::ValidationError("IDENTITY", "is missing: name a CONCEPT, --id N or --text NAME");
  options.publication.identity = std::move(*identity);
  if (options.publication.port == 0 && !options.sends) {
    throw CLI::RequiredError("--port");
  }
  options.publication.mode = options.shared.mode_or_stream();
  for (; word != options.words.end(); ++word) {
    const auto pair = shell::key_and_value(*word);
    if (pair && pair->first == converts) {  // as in GCNP, where it does not count as a misspelled `convert` either
      if (const auto fault = conversion_fault(pair->second); !fault.empty()) throw CLI::ValidationError(*word, fault);
      add_attribute(options.publication.attributes, *word, converts);
      continue;
    }
    const auto name = attribute_name(word->substr(0, word->find('=')));
    if (!name) throw CLI::ValidationError(*word, name.error().text);
    add_attribute(options.publication.attributes, *word, *name);
  }
  if (!options.converts.empty())
    add_attribute(options.publication.attributes, converts + ("=" + options.converts), converts);
  for (const auto& stated : options.attributes) {
    std::string name = stated.substr(0, stated.find('='));
    if (name.starts_with(attribute_prefix)) name.erase(0, attribute_prefix.size());
    add_attribute(options.publication.attributes, stated, name);
  }
}

std::expected<void, ClientError> begin(const Options& options, Client& client) {
  const auto request = client.publish(options.publication);
  if (!request) return std::unexpected(request.error());
  const Welcome& welcome = client.welcome();
  const std::string service = to_string(ServiceKey{welcome.participant, welcome.peer, *request});
  if (options.shared.common.is_json) {
    shell::print(std::cout, shell::stamped({{"event", "offered"}, {"service", service}}));
  } else {
    std::cerr << program << ": offering " << shell::printable(shell::identity_words(options.publication.identity))
              << " as " << service << '\n'
              << std::flush;
  }
  return {};
}

int run(int argc, char** argv) {
  CLI::App app("Offers one service until it is ended, and prints who consumes it.", std::string(program));
  app.footer(std::string(examples) + std::string(shell::exec_words));
  Options options;
  add_to(app, options);
  app.callback([&options] { complete(options); });
  if (const auto status = shell::parse(app, argc, argv)) return static_cast<int>(*status);

  const auto commands = options.shared.commands(program);
  shell::EventPrinter<ConsumerEvent> printer(program, options.shared.printer(commands.get()));
  shell::Stream stream = options.shared.stream(program, commands.get());
  stream.connection.timeout = options.shared.common.timeout_or(stream.connection.timeout);
  if (options.sends) {
    return static_cast<int>(
        shell::send({program, stream.connection, std::nullopt, 0, stream.is_kept}, options.publication));
  }
  stream.begin = [&options](Client& client) { return begin(options, client); };
  return static_cast<int>(shell::run(stream, printer));
}

}  // namespace
}  // namespace geminga::publish

int main(int argc, char** argv) {
  const geminga::shell::WholeLines lines;
  return geminga::publish::run(argc, argv);
}
