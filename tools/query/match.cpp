// geminga-query match: the publications that match an identity, best first.
#include <CLI/CLI.hpp>
#include <memory>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "query/near.hpp"
#include "query/services.hpp"
#include "shell/describe.hpp"

namespace geminga::query {
namespace {

struct Flags {
  std::vector<std::string> words;
  std::string concept_name;
  shell::IdentityOptions identity;
  std::optional<ChannelMode> mode;
  Degree degree = Degree::narrower;
  std::string where;
  std::string on;
  std::vector<std::string> providers;
  std::uint32_t limit = 0;
  std::string convert;
  bool is_missing_wanted = false;
};

shell::Table table(const std::vector<Record>& records) {
  shell::Table shown({{"DEGREE"},
                      {"DISTANCE", true, 0, 4},
                      {"PROVIDER", false, 12},
                      {"IDENTITY", false, 16},
                      {"MODE", false, 0, 3},
                      {"ADDRESS", false, 15, 1},
                      {"PRIO", true, 0, 6},
                      {"AGE", true, 0, 7},
                      {"SERVICE"},
                      {"CONVERT", false, 16, 8},
                      {"COST", true, 0, 8},
                      {"VIA", false, 16, 8},
                      {"ATTRIBUTES", false, 10, 5}});
  for (const auto& record : records) {
    shown.add({record["degree"], record["distance"],
               shell::who(record["provider"], record["name"], record["participant_name"]),
               shell::identity_words(record), record["mode"], shell::place(record["address"], record["port"]),
               record["priority"], shell::duration_words(record["age"]), record["service"], record["convert"],
               record["cost"], record["via"], shell::attribute_words(record.attributes)});
  }
  return shown;
}

/// Reads the positional words. Throws CLI::ValidationError.
void read_words(Flags& flags) {
  for (const std::string& word : flags.words) {
    if (flags.identity.takes(word)) continue;
    const auto pair = shell::key_and_value(word);
    if (pair && pair->first != "concept") {
      throw CLI::ValidationError(
          word,
          "is no part of an identity: flags are --degree, --mode, --convert, --provider and --limit, "
          "attributes are asked for with --where '" +
              pair->first + " = " + pair->second + "'");
    }
    if (pair && pair->second.empty()) throw CLI::ValidationError(word, std::string(shell::nothing_behind));
    if (!flags.concept_name.empty()) {
      throw CLI::ValidationError(word, "is a second concept: write a class expression in quotes, e.g. 'A or B'");
    }
    flags.concept_name = pair ? pair->second : word;
  }
}

/// The nearest service, why it does not match, and what would mend that.
std::string reason_of(Client& client, Parameters asked) {
  for (auto& [key, value] : asked) {
    if (key == "degree") key = "match";
  }
  const auto answer = client.query("why", asked);
  if (!answer || answer->end["text"].empty()) return "";
  return "nothing matches: " + std::string(answer->end["text"]) + ": " + std::string(answer->end["mend"]);
}

Listing listing_of(const Flags& flags) {
  Listing listing{"match",
                  {},
                  {},
                  "service",
                  table,
                  service_line,
                  "nothing matches: see geminga-query services for what is offered"};
  auto& parameters = listing.parameters;
  const auto identity = flags.identity.identity(flags.concept_name);
  if (identity) {
    if (const auto* number = std::get_if<NumericIdentity>(&*identity)) {
      parameters.emplace_back("id", std::to_string(number->number));
    } else if (const auto* text = std::get_if<TextIdentity>(&*identity)) {
      parameters.emplace_back("text", text->text);
    } else {
      const auto& names = std::get<ConceptNames>(*identity);
      parameters.emplace_back("concept", names.concept_name);
      if (!names.representation_name.empty()) parameters.emplace_back("representation", names.representation_name);
    }
  }
  if (flags.degree != Degree::narrower) parameters.emplace_back("degree", to_string(flags.degree));
  if (flags.mode) parameters.emplace_back("mode", to_string(*flags.mode));
  if (!flags.where.empty()) parameters.emplace_back("where", flags.where);
  if (!flags.on.empty()) parameters.emplace_back("on", flags.on);
  if (!flags.providers.empty()) parameters.emplace_back("provider", CLI::detail::join(flags.providers, ","));
  if (!flags.convert.empty()) parameters.emplace_back("convert", flags.convert);
  if (flags.limit != 0) parameters.emplace_back("limit", std::to_string(flags.limit));
  if (flags.is_missing_wanted) {
    if (!identity || !std::holds_alternative<ConceptNames>(*identity)) {
      throw CLI::ValidationError("--missing", "needs a concept: a number or a text lacks nothing");
    }
    parameters.emplace_back("missing", "1");
    listing.table = table_of_near;
    listing.is_found = is_match;
  }
  if (identity) listing.reason = [asked = parameters](Client& client) { return reason_of(client, asked); };
  return listing;
}

}  // namespace

void add_match(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand("match", "List the publications that match an identity, best first");
  const auto flags = std::make_shared<Flags>();
  command->add_option("IDENTITY", flags->words,
                      "A concept (prefix:Name, <IRI>, a label or a class expression), or id=N, text=NAME, concept=C, "
                      "representation=R; without any, everything is listed");
  command->add_option("--concept", flags->concept_name, "The concept")->type_name("C");
  flags->identity.add_to(*command);
  shell::add_degree(*command, flags->degree);
  shell::add_mode(*command, flags->mode, "Only this channel mode");
  command->add_option("--where", flags->where, "Only services whose attributes fulfil this condition")
      ->type_name("EXPRESSION");
  command
      ->add_option("--on", flags->on,
                   "Only on robots that are known to be this by their descriptions: a class or a class expression")
      ->type_name("EXPRESSION");
  command->add_option("--provider", flags->providers, "Only these providers")
      ->type_name("PARTICIPANT[/PEER]")
      ->allow_extra_args(false);
  command
      ->add_option("--convert", flags->convert,
                   "Also services whose representation can be converted: yes, no or the largest cost")
      ->type_name("yes|no|COST");
  command->add_option("--limit", flags->limit, "At most this many, the best")
      ->type_name("N")
      ->check(shell::whole_number(0, UINT32_MAX), "", "");
  command->add_flag(
      "--missing", flags->is_missing_wanted,
      "Also services that come near, at most as many as --limit says, with what they are not known to be and what "
      "contradicts");
  command->footer(
      "Examples:\n  geminga-query match soccer:TrackedObject\n  geminga-query match text=camera\n"
      "  geminga-query match 'soccer:BallInfo or soccer:GoalInfo'\n"
      "  geminga-query match soccer:BallInfo --representation soccer:CartesianFieldFrame --mode otm/stream\n"
      "  geminga-query match soccer:BallInfo --representation soccer:CartesianFieldFrame --convert yes\n"
      "  geminga-query match --id 0x30242948\n  geminga-query match soccer:BallInfo --where 'rate >= 30' --limit 1\n"
      "  geminga-query match soccer:BallInfo --on 'Robot and hasPart some Arm'\n"
      "  geminga-query match soccer:SharedBallInfo --missing");
  command->callback([flags, &selected] {
    read_words(*flags);
    auto listing = listing_of(*flags);  // throws where the identity is not one
    selected = [listing = std::move(listing)](const Context& context, Client& client) {
      return show(context, client, listing);
    };
  });
}

}  // namespace geminga::query
