// geminga-query complete: the words that a shell may offer next, for its completion. --help does not show it.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <memory>

#include "query/command.hpp"
#include "query/services.hpp"
#include "shell/describe.hpp"
#include "shell/terminal.hpp"

namespace geminga::query {
namespace {

/// The most words that are offered. A reader looks through fewer, and a shell becomes slow.
constexpr std::uint32_t max_words = 1000;

/// The seconds after which the program ends, whatever it waits for: somebody waits for a key to take effect.
constexpr unsigned longest_wait = 2;

/// Words with what is said of each, in the order of the words.
class Words {
 public:
  explicit Words(std::string beginning) : beginning_(std::move(beginning)) {}

  /// Takes a word that begins as asked; the first description of a word counts.
  void add(std::string_view word, const std::string& description = {}) {
    // No word that anybody types has characters that a terminal could obey.
    if (word.empty() || !word.starts_with(beginning_) || shell::printable(word) != word) return;
    if (words_.size() < max_words) words_.try_emplace(std::string(word), shell::printable(description));
  }
  [[nodiscard]] const std::string& beginning() const { return beginning_; }
  void print() const {
    for (const auto& [word, description] : words_) std::cout << word << '\t' << description << '\n';
  }

 private:
  std::string beginning_;
  std::map<std::string, std::string> words_;
};

/// The records of a query; none where it is refused.
std::vector<Record> records_of(Client& client, const std::string& kind, const Parameters& parameters = {}) {
  auto answer = client.query(kind, parameters);
  return answer ? std::move(answer->records) : std::vector<Record>();
}

std::string party_of(const Record& record, std::string_view role) {
  return shell::who(record[role], record["name"], record["participant_name"]);
}

void offer_requests(Client& client, Words& words) {
  for (const Record& record : records_of(client, "requests")) {
    const bool is_served = record["served"] == "1";
    words.add(record["subscription"], party_of(record, "consumer") + " asks for " + shell::identity_words(record) +
                                          (is_served ? "" : ", nobody serves it"));
  }
}

void offer_services(Client& client, Words& words) {
  for (const Record& record : records_of(client, "services")) {
    words.add(record["service"], party_of(record, "provider") + " offers " + shell::identity_words(record));
  }
}

void offer_either(Client& client, Words& words) {
  offer_requests(client, words);
  offer_services(client, words);
}

/// The values of a key that somebody offers or asks for.
void offer_used(Client& client, Words& words, const char* key) {
  for (const Record& record : records_of(client, "services")) words.add(record[key], "offered");
  for (const Record& record : records_of(client, "requests")) {
    // A class expression is no single word, and `requests` tells it by the same key.
    if (!record[key].contains(' ')) words.add(record[key], "asked for");
  }
}

void offer_classes(Client& client, Words& words) {
  const Parameters asked{{"begin", words.beginning()}, {"limit", std::to_string(max_words)}};
  for (const Record& record : records_of(client, "concepts", asked)) words.add(record["concept"]);
}

void offer_concepts(Client& client, Words& words) {
  offer_used(client, words, "concept");
  offer_classes(client, words);
}

void offer_representations(Client& client, Words& words) {
  offer_used(client, words, "representation");
  offer_classes(client, words);
}

void offer_texts(Client& client, Words& words) { offer_used(client, words, "text"); }

void offer_participants(Client& client, Words& words) {
  for (const Record& record : records_of(client, "participants")) {
    words.add(record["name"], std::string(record["id"]) + ' ' + std::string(record["addresses"]));
  }
}

/// `PARTICIPANT` and, of those that offer something, `PARTICIPANT/PEER`.
void offer_providers(Client& client, Words& words) {
  offer_participants(client, words);
  for (const Record& record : records_of(client, "services")) {
    if (record["name"].empty() || record["participant_name"].empty()) continue;
    words.add(std::string(record["participant_name"]) + '/' + std::string(record["name"]), "offers something");
  }
}

void offer_filters(Client& client, Words& words) {
  offer_concepts(client, words);
  offer_participants(client, words);
}

struct Kind {
  const char* name;
  void (*offer)(Client& client, Words& words);
};

/// The kinds of words, by the names that src/manual/outline.cpp gives them.
constexpr auto kinds = std::to_array<Kind>({{"request", offer_requests},
                                            {"service", offer_services},
                                            {"either", offer_either},
                                            {"concept", offer_concepts},
                                            {"representation", offer_representations},
                                            {"text", offer_texts},
                                            {"provider", offer_providers},
                                            {"filter", offer_filters}});

}  // namespace

void add_complete(CLI::App& app, RunEvenAlone& selected) {
  CLI::App* command = app.add_subcommand("complete", "Prints what a shell may offer: WORD<TAB>DESCRIPTION lines");
  command->group("");
  struct Asked {
    std::string kind;
    std::string beginning;
  };
  const auto asked = std::make_shared<Asked>();
  command->add_option("KIND", asked->kind)->required();
  command->add_option("BEGINNING", asked->beginning);
  command->callback([&selected, asked] {
    ::alarm(longest_wait);
    selected = [asked](const Context&, Result<Client, ClientError>& client) {
      const auto* const kind = std::ranges::find_if(kinds, [&](const Kind& one) { return asked->kind == one.name; });
      if (client && kind != kinds.end()) {
        Words words(asked->beginning);
        kind->offer(*client, words);
        words.print();
      }
      return shell::ExitStatus::found;  // a shell that gets no words offers none
    };
  });
}

}  // namespace geminga::query
