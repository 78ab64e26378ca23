// geminga-query why: why a request and a service match or do not, or why a request has no provider, or a service no
// consumer.
#include "answers/why.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <span>
#include <sstream>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

using answers::About;
using answers::Question;

struct Flag {
  const char* name;
  const char* key;
  const char* type;
  const char* meaning;
};

constexpr auto request_flags = std::to_array<Flag>({
    {"--concept", "concept", "C", "This concept: prefix:Name, <IRI>, a label or a class expression"},
    {"--representation", "representation", "R", "In this representation"},
    {"--id", "id", "N", "This number instead of a concept"},
    {"--text", "text", "NAME", "This text instead of a concept"},
    {"--mode", "mode", "oto|otm/stream|otm/pubsub", "In this mode; default: any"},
    {"--match,--degree", "match", "exact|equivalent|narrower|broader|overlapping", "The weakest degree that counts"},
    {"--where", "where", "EXPRESSION", "Whose attributes fulfil this condition"},
    {"--protocol", "protocol", "P,...", "In one of these protocols"},
    {"--provider", "provider", "PARTICIPANT[/PEER],...", "From one of these"},
    {"--favour", "favour", "PARTICIPANT[/PEER],...", "From these first, then from all others"},
    {"--prefer", "prefer", "WISHES", "Those whose attributes are best, e.g. 'rate desc'"},
    {"--rank", "rank", "CRITERIA", "The criteria that rank providers, the first one first"},
    {"--on", "on", "EXPRESSION", "On participants that are known to be this, by their descriptions"},
    {"--scope", "scope", "HOSTS", "From these hosts: host, group, any, names, and ! before what is excluded"},
    {"--convert", "convert", "yes|no|COST", "Also what can be converted at this cost"},
    {"--reach", "reach", "routed|any", "any: also what cannot be reached from this host"},
    {"--limit", "limit", "N", "From so many providers at most (default: 1 where the mode is oto, else all)"},
});

constexpr auto offer_flags = std::to_array<Flag>({
    {"--offer-concept", "offer.concept", "C", "This concept"},
    {"--offer-representation", "offer.representation", "R", "In this representation"},
    {"--offer-id", "offer.id", "N", "This number instead of a concept"},
    {"--offer-text", "offer.text", "NAME", "This text instead of a concept"},
    {"--offer-mode", "offer.mode", "oto|otm/stream|otm/pubsub", "In this mode (default: that of each request)"},
    {"--offer-protocol", "offer.protocol", "P", "In this protocol"},
    {"--offer-provider", "offer.provider", "PARTICIPANT[/PEER]", "By this provider (default: a peer of this host)"},
    {"--offer-priority", "offer.priority", "K", "With this priority"},
    {"--offer-scope", "offer.scope", "HOSTS", "For these hosts"},
    {"--offer-for", "offer.for", "EXPRESSION", "For consumers whose attributes fulfil this condition"},
    {"--offer-address", "offer.address", "A", "At this address"},
    {"--offer-port", "offer.port", "P", "At this port"},
});

void add_flags(CLI::App& command, const std::shared_ptr<Question>& question, std::span<const Flag> flags,
               const char* group) {
  for (const Flag& flag : flags) {
    command
        .add_option_function<std::string>(
            flag.name,
            [question, key = flag.key](const std::string& value) { question->parameters.emplace_back(key, value); },
            flag.meaning)
        ->type_name(flag.type)
        ->group(group);
  }
}

constexpr const char* request_group = "What might be asked for, instead of SUBSCRIPTION";
constexpr const char* offer_group = "What might be offered, instead of SERVICE";

void add_attributes(CLI::App& command, const std::shared_ptr<Question>& question, const char* name, const char* prefix,
                    const char* meaning, const char* group) {
  command
      .add_option_function<std::vector<std::string>>(
          name,
          [question, prefix](const std::vector<std::string>& words) {
            for (const std::string& word : words) {
              const auto pair = shell::key_and_value(word);
              if (!pair) throw CLI::ValidationError(word, "is no attribute: write KEY=VALUE");
              question->parameters.emplace_back(prefix + pair->first, pair->second);
            }
          },
          meaning)
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->group(group);
}

/// Throws CLI::ValidationError where the flags do not make one question.
void check(const Question& question) {
  const bool is_imagined = question.has_any({"concept", "id", "text"});
  const bool is_offer_alone = question.has_service() && !question.has_request();
  if (!is_imagined && question.subscription.empty() && !is_offer_alone) {
    throw CLI::ValidationError(
        "SUBSCRIPTION",
        "is missing: name a request, or say with --concept, --id or --text what might be asked for; "
        "--service or --offer-concept and its like alone ask who takes a service");
  }
  const bool is_offer_imagined =
      std::ranges::any_of(question.parameters, [](const auto& one) { return one.first.starts_with("offer."); });
  if (!question.service.empty() && is_offer_imagined) {
    throw CLI::ValidationError("SERVICE", "does not go with --offer-concept and its like: one service at a time");
  }
  if (question.has_service() && question.service.empty() &&
      !question.has_any({"offer.concept", "offer.id", "offer.text"})) {
    throw CLI::ValidationError("--offer-concept",
                               "is missing: say with it, --offer-id or --offer-text what is offered");
  }
  if (is_imagined && !question.subscription.empty()) {
    throw CLI::ValidationError("SUBSCRIPTION",
                               "does not go with --concept, --id or --text: --service names a service, "
                               "--offer-concept and its like say what might be offered");
  }
}

/// Prints a sentence whose first words have a colour.
void print_led(const Context& context, shell::Colour colour, std::string_view lead, const std::string& rest) {
  const std::string head = shell::printable(lead);
  std::ostringstream lines;
  shell::print_wrapped(lines, context.terminal, head + shell::printable(rest));
  std::cout << coloured(context.terminal, colour, head) << std::string_view(lines.view()).substr(head.size());
}

void print_mend(const Context& context, std::string_view code, std::string_view mend) {
  if (!mend.empty()) print_led(context, shell::Colour::dim, code, ": " + std::string(mend));
}

void print_proof(const Context& context, const Record& record) {
  std::istringstream lines{std::string(record["proof"])};
  for (std::string line; std::getline(lines, line);) {
    shell::print_wrapped(std::cout, context.terminal, shell::printable(line), 2);
  }
}

/// Lists what is not known of the service, and what contradicts, by the smallest way; then the others.
void print_missing(const Context& context, const Record& record) {
  const auto list = [&](const char* title, const char* key) {
    if (record[key].empty()) return;
    std::cout << title << '\n';
    std::istringstream lines{std::string(record[key])};
    for (std::string line; std::getline(lines, line);) {
      shell::print_wrapped(std::cout, context.terminal, shell::printable(line), 2);
    }
  };
  list("not known of it", "missing");
  list("contradicts it", "contradicting");
  list("or", "ways");
  list("but", "reservation");
}

void print_pair(const Context& context, const Answer& answer) {
  const bool is_match = answer.end["matches"] == "1";
  std::string verdict = is_match                        ? ": they match"
                        : answers::is_outranked(answer) ? ": they would match, and others are better"
                                                        : ": they do not match";
  if (!answer.end["degree"].empty()) {
    verdict += ", degree " + std::string(answer.end["degree"]) + ", distance " + std::string(answer.end["distance"]);
  }
  print_led(context, is_match ? shell::Colour::green : shell::Colour::red, is_match ? "yes" : "no", verdict);
  shell::Table table({{"CHECK"}, {"OK"}, {"WHY", false, 20}});
  for (const auto& record : answer.records) {
    table.add({record["check"], record["ok"] == "1" ? "yes" : "no", record["text"]});
  }
  table.print(std::cout, context.terminal);
  for (const auto& record : answer.records) {
    if (!record["proof"].empty()) {
      std::cout << "because\n";
      print_proof(context, record);
    }
  }
  for (const auto& record : answer.records) print_mend(context, record["code"], record["mend"]);
  for (const auto& record : answer.records) print_missing(context, record);
}

/// The keys and words of a sum: how many of the known services meet a request, or of the known requests take a service.
struct Sum {
  const char* count;
  const char* known;
  const char* noun;
  const char* verb;
};

void print_sum(const Context& context, const Record& end, const Sum& sum, bool is_yes, const std::string& more) {
  const std::string known(end[sum.known]);
  if (is_yes) {
    print_led(context, shell::Colour::green, "yes",
              ": " + std::string(end[sum.count]) + " of the " + known + ' ' + sum.noun + "s that are known " +
                  sum.verb + (end[sum.count] == "1" ? "s it" : " it") + more);
    return;
  }
  print_led(
      context, shell::Colour::red, "no",
      ": " + std::string(end["text"]) + " (" + known + ' ' + sum.noun + (known == "1" ? " is known)" : "s are known)"));
  print_mend(context, end["code"], end["mend"]);
}

void print_request(const Context& context, const Answer& answer) {
  const Record& end = answer.end;
  const std::string more =
      end["gaps"].empty()
          ? ""
          : "; the answer may be incomplete, as no class is defined by the expression: " + std::string(end["gaps"]);
  print_sum(context, end, {"matching", "offers", "service", "meet"}, end["served"] == "1", more);
  shell::Table table({{"PROVIDER", false, 12},
                      {"OFFERS", false, 16},
                      {"MODE", false, 0, 3},
                      {"OK"},
                      {"WHY", false, 20, 0, true},
                      {"SERVICE"}});
  for (const auto& record : answer.records) {
    table.add({shell::who(record["provider"], record["name"], record["participant_name"]), record["offered"],
               record["mode"], record["ok"] == "1" ? "yes" : "no", record["text"], record["service"]});
  }
  table.print(std::cout, context.terminal);
}

void print_service(const Context& context, const Answer& answer) {
  const Record& end = answer.end;
  const std::string more = end["matching"] == end["taken"] ? "" : ", " + std::string(end["matching"]) + " match it";
  print_sum(context, end, {"taken", "requests", "request", "take"}, end["taken"] != "0", more);
  shell::Table table({{"CONSUMER", false, 12},
                      {"ASKS FOR", false, 16},
                      {"MODE", false, 0, 3},
                      {"OK"},
                      {"WHY", false, 20, 0, true},
                      {"REQUEST"}});
  for (const auto& record : answer.records) {
    table.add({shell::who(record["consumer"], record["name"], record["participant_name"]), record["asked"],
               record["mode"], record["ok"] == "1" ? "yes" : "no", record["text"], record["subscription"]});
  }
  table.print(std::cout, context.terminal);
}

std::expected<Answer, ClientError> ask(Client& client, const Question& question) {
  Parameters parameters = question.parameters;
  if (!question.subscription.empty()) parameters.emplace_back("subscription", question.subscription);
  if (!question.service.empty()) parameters.emplace_back("service", question.service);
  return client.query("why", parameters);
}

bool is_not_there(const std::expected<Answer, ClientError>& answer) {
  return !answer && answer.error().kind == ClientError::Kind::refused &&
         answer.error().code == ErrorCode::unknown_request;
}

shell::ExitStatus answer_to(const Context& context, Client& client, Question question) {
  if (refuses_watch(context, "why")) return shell::ExitStatus::wrong_use;
  auto answer = ask(client, question);
  if (is_not_there(answer) && !question.subscription.empty() && !question.has_service()) {
    // The one word may be that of a service: requests and services share their numbers.
    Question other = question;
    std::swap(other.subscription, other.service);
    auto of_service = ask(client, other);
    if (!is_not_there(of_service)) {
      answer = std::move(of_service);
      question = std::move(other);
    }
  }
  if (!answer) return shell::report(program, answer.error());
  const Record& end = answer->end;
  const About what = answers::about(question);
  const bool is_yes =
      what == About::service ? end["taken"] != "0" : end[what == About::pair ? "matches" : "served"] == "1";
  if (context.common.is_json) {
    shell::print(std::cout, answers::why_document(question, *answer));
  } else if (what == About::pair) {
    print_pair(context, *answer);
  } else if (what == About::request) {
    print_request(context, *answer);
  } else {
    print_service(context, *answer);
  }
  return is_yes ? shell::ExitStatus::found : shell::ExitStatus::nothing;
}

}  // namespace

void add_why(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand(
      "why", "Tell why a request and a service match or do not, or why nobody answers a request or takes a service");
  const auto question = std::make_shared<Question>();
  command->add_option(
      "SUBSCRIPTION", question->subscription,
      "The word in the column REQUEST of geminga-query requests; or a SERVICE alone, to ask who takes it, or "
      "why nobody does");
  CLI::Option* service = command->add_option(
      "SERVICE", question->service,
      "The word in the column SERVICE of geminga-query services; without it: who answers, or why nobody does");
  command->add_option("--service", question->service, "The same as SERVICE")->type_name("WORD")->excludes(service);
  add_flags(*command, question, request_flags, request_group);
  add_flags(*command, question, offer_flags, offer_group);
  add_attributes(*command, question, "--attribute", "attr.", "With this attribute; may be given several times",
                 request_group);
  add_attributes(*command, question, "--offer-attribute", "offer.attr.",
                 "With this attribute; may be given several times", offer_group);
  command->footer(
      "Examples:\n  geminga-query why 5e6f7a8b/2/1\n  geminga-query why 5e6f7a8b/2/1 1a2b3c4d/1/42\n"
      "  geminga-query why 1a2b3c4d/1/42\n  geminga-query why --offer-concept soccer:BallInfo --offer-attribute "
      "rate=30\n"
      "  geminga-query why --concept soccer:BallInfo --representation soccer:PolarFieldFrame --where 'rate >= 50'\n"
      "  geminga-query why --concept soccer:BallInfo --mode oto --service 1a2b3c4d/1/42\n"
      "  geminga-query why 5e6f7a8b/2/1 --offer-concept soccer:BallInfo --offer-attribute rate=30\n"
      "Exit status 0: they match, or somebody answers or takes it; 1: they do not match, better ones fill the limit, "
      "nobody answers or takes it, or one of them is not known.");
  command->callback([question, &selected] {
    check(*question);
    selected = [question](const Context& context, Client& client) { return answer_to(context, client, *question); };
  });
}

}  // namespace geminga::query
