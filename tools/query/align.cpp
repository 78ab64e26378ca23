// geminga-query ontology --align: what another participant's ontology would mean here, as links that a person accepts.
#include "query/align.hpp"

#include <stdlib.h>

#include <algorithm>
#include <boost/json.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>

#include "query/aligning/understood.hpp"
#include "query/ontology_program.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

namespace fs = std::filesystem;
using shell::ExitStatus;

/// The seconds of one search of geminga-ontology.
constexpr const char* search_seconds = "300";

/// A folder for what is needed in between, removed with it.
class Workshop {
 public:
  Workshop() {
    std::string path = (fs::temp_directory_path() / "geminga-align-XXXXXX").string();
    if (::mkdtemp(path.data()) != nullptr) folder_ = path;
  }
  ~Workshop() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  [[nodiscard]] bool is_there() const { return !folder_.empty(); }
  [[nodiscard]] std::string operator/(const char* name) const { return (folder_ / name).string(); }

 private:
  fs::path folder_;
};

ClientError no_closure() {
  return {ClientError::Kind::wrong_use, "what follows from the ontologies cannot be found out: see above"};
}

struct Link {
  std::string one;
  std::string relation;
  std::string other;
  std::string confidence;
  std::string reason;
};

std::vector<Link> links_in(const std::string& file) {
  std::ifstream in(file);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  boost::system::error_code error;
  const auto document = boost::json::parse(text, error);
  std::vector<Link> links;
  if (error || !document.is_object() || !document.as_object().contains("links")) return links;
  for (const auto& value : document.at("links").as_array()) {
    const auto word = [&](const char* key) { return std::string(value.at(key).as_string()); };
    const long hundredths = std::lround(value.at("confidence").to_number<double>() * 100);
    links.push_back({word("one"), word("relation"), word("other"), std::to_string(hundredths) + " %", word("reason")});
  }
  return links;
}

Closure closure_in(const std::string& file, const std::set<std::string, std::less<>>& wanted) {
  std::ifstream in(file);
  return Closure::read(in, wanted);
}

/// The files that the daemon has loaded.
std::expected<std::vector<std::string>, ClientError> loaded_files(Client& client) {
  const auto answer = client.query("ontology");
  if (!answer) return std::unexpected(answer.error());
  std::vector<std::string> files;
  for (const Record& record : answer->records) {
    if (!record["file"].empty()) files.emplace_back(record["file"]);
  }
  return files;
}

class Alignment {
 public:
  Alignment(const Context& context, Client& client, const AlignFlags& flags)
      : context_(context), client_(client), flags_(flags) {}

  ExitStatus run() {
    if (!workshop_.is_there()) return refuse("no temporary folder can be made: set TMPDIR");
    const auto files = loaded_files(client_);
    if (!files) return shell::report(program, files.error());
    if (files->empty()) return refuse("the daemon has loaded no ontology: start it with --ontology");
    ours_ = *files;
    std::error_code error;
    if (!fs::create_directories(flags_.folder, error) && (error || !fs::is_empty(flags_.folder, error)))
      return refuse(flags_.folder + ": holds something already, or cannot be made: name another folder");
    theirs_ = (fs::path(flags_.folder) / "theirs").string();
    links_file_ = (fs::path(flags_.folder) / "alignment.ttl").string();
    if (const auto failed = fetch()) return *failed;
    if (const auto failed = align()) return *failed;
    const auto understood = compare();
    if (!understood) return shell::report(program, understood.error());
    context_.common.is_json ? print_document(*understood) : print_words(*understood);
    return links_.empty() ? ExitStatus::nothing : ExitStatus::found;
  }

 private:
  ExitStatus refuse(const std::string& why) {
    shell::complain(program, why);
    return ExitStatus::wrong_use;
  }

  /// Nothing where it has gone well, as of the others.
  std::optional<ExitStatus> fetch() {
    std::vector<std::string> words{"fetch", "--newest", "--from=" + flags_.participant, "-o", theirs_};
    if (!context_.common.connect.empty()) words.push_back("--connect=" + context_.common.connect);
    if (flags_.is_open) words.emplace_back("--open");
    const int status = run_ontology_program(words, "/dev/null");
    if (status == 0) return std::nullopt;
    std::error_code ignored;
    fs::remove(flags_.folder, ignored);  // it is empty
    return status > 0 && status <= 4 ? static_cast<ExitStatus>(status) : ExitStatus::wrong_use;
  }

  std::optional<ExitStatus> align() {
    const std::string merged = workshop_ / "ours.ttl";
    std::vector<std::string> merge{"merge"};
    merge.insert(merge.end(), ours_.begin(), ours_.end());
    merge.insert(merge.end(), {"-o", merged});
    if (run_ontology_program(merge, "/dev/null") != 0)
      return refuse("the files that the daemon has loaded cannot be read any more");
    std::vector<std::string> words{"align",     merged,   theirs_,        "-o",
                                   links_file_, "--json", "--time-limit", search_seconds};
    if (flags_.is_conservative) words.emplace_back("--conservative");
    if (flags_.has_subsumptions) words.emplace_back("--subsumptions");
    const int status = run_ontology_program(words, workshop_ / "links.json");
    if (status != 0 && status != 1 && status != 4) return refuse("the two ontologies cannot be aligned");
    links_ = links_in(workshop_ / "links.json");
    return std::nullopt;
  }

  std::expected<Understood, ClientError> compare() {
    const auto services = client_.query("services", {{"iris", "1"}});
    if (!services) return std::unexpected(services.error());
    const auto requests = client_.query("requests", {{"iris", "1"}});
    if (!requests) return std::unexpected(requests.error());
    std::vector<std::string> classify{"classify", "--closure", "--time-limit", search_seconds, workshop_ / "ours.ttl"};
    if (run_ontology_program(classify, workshop_ / "today") < 0) return std::unexpected(no_closure());
    classify.insert(classify.end(), {theirs_, links_file_});
    if (run_ontology_program(classify, workshop_ / "with") < 0) return std::unexpected(no_closure());
    auto wanted = concepts_of(services->records, requests->records);
    const Closure with = closure_in(workshop_ / "with", wanted);
    const std::vector<std::string> stated(wanted.begin(), wanted.end());
    for (const std::string& iri : stated) wanted.insert(with.above(iri).begin(), with.above(iri).end());
    const Closure today = closure_in(workshop_ / "today", wanted);
    return understood_with(services->records, requests->records, today, with, [this](const std::string& iri) {
      return client_.query("taxonomy", {{"class", '<' + iri + '>'}, {"limit", "1"}}).has_value();
    });
  }

  void print_words(const Understood& understood) const {
    std::ostream& out = std::cout;
    shell::Table links(
        {{"OURS", false, 20}, {"", false}, {"THEIRS", false, 20}, {"SURE", true}, {"WHY", false, 20, 1}});
    for (const Link& link : links_) links.add({link.one, link.relation, link.other, link.confidence, link.reason});
    links.print(out, context_.terminal, "Links (= the same, < narrower, > broader):\n");
    if (links_.empty()) out << "No links were found.\n";
    shell::Table meanings({{"OFFERED", false, 20}, {"PROVIDER", false, 12}, {"WOULD BE", false, 20}});
    for (const Meaning& meaning : understood.meanings) {
      std::string classes;
      for (const std::string& one : meaning.classes) classes += (classes.empty() ? "" : ", ") + one;
      meanings.add(
          {meaning.service["concept"],
           shell::who(meaning.service["provider"], meaning.service["name"], meaning.service["participant_name"]),
           classes});
    }
    meanings.print(out, context_.terminal,
                   "\nServices without a meaning here, and what they would be with the links:\n");
    shell::Table meetings({{"OFFERED", false, 20}, {"SERVICE"}, {"ASKED FOR", false, 20}, {"REQUEST"}});
    for (const Meeting& one : understood.meetings)
      meetings.add(
          {one.service["concept"], one.service["service"], one.request["concept"], one.request["subscription"]});
    meetings.print(out, context_.terminal,
                   "\nServices and requests that would meet, and do not today (where, scope and protocol aside):\n");
    if (understood.meetings.empty())
      out << "\nWith the links, no further services and requests would match at present.\n";
    if (understood.expressions > 0)
      out << understood.expressions << " services and requests of class expressions are not compared.\n";
    out << "\nNothing is in force yet. A wrong link sends a robot the wrong data: read "
        << shell::printable(links_file_)
        << ",\ntake out what is wrong, and accept the rest by giving the folder to the daemon:\n  cp -r "
        << shell::printable(flags_.folder) << " " << shell::printable(fs::path(ours_.front()).parent_path().string())
        << "/ && systemctl reload gemingad\n"
        << "Conversions between representations are never guessed: state them with geminga:convertsTo.\n";
  }

  void print_document(const Understood& understood) const {
    boost::json::object document{{"folder", flags_.folder}, {"alignment", links_file_}};
    auto& links = document["links"].emplace_array();
    for (const Link& link : links_)
      links.push_back(boost::json::object{{"one", link.one},
                                          {"relation", link.relation},
                                          {"other", link.other},
                                          {"confidence", link.confidence},
                                          {"reason", link.reason}});
    auto& meanings = document["meanings"].emplace_array();
    for (const Meaning& meaning : understood.meanings) {
      boost::json::object object{{"service", meaning.service["service"]}, {"concept", meaning.service["concept"]}};
      auto& classes = object["classes"].emplace_array();
      for (const std::string& one : meaning.classes) classes.push_back(boost::json::string(one));
      meanings.push_back(std::move(object));
    }
    auto& meetings = document["meetings"].emplace_array();
    for (const Meeting& one : understood.meetings)
      meetings.push_back(boost::json::object{{"service", one.service["service"]},
                                             {"offered", one.service["concept"]},
                                             {"request", one.request["subscription"]},
                                             {"asked", one.request["concept"]}});
    document["not_compared"] = understood.expressions;
    shell::print(std::cout, document);
  }

  const Context& context_;
  Client& client_;
  const AlignFlags& flags_;
  Workshop workshop_;
  std::vector<std::string> ours_;
  std::string theirs_;
  std::string links_file_;
  std::vector<Link> links_;
};

}  // namespace

ExitStatus align(const Context& context, Client& client, const AlignFlags& flags) {
  return Alignment(context, client, flags).run();
}

}  // namespace geminga::query
