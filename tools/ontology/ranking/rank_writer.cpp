#include "ontology/ranking/rank_writer.hpp"

#include <algorithm>
#include <boost/json.hpp>
#include <cstdio>

#include "base/text.hpp"
#include "ontology/command/words.hpp"

namespace geminga::ontology {
namespace {

using signature::Concept;
using signature::Pair;

std::string decimal(double value, int digits) {
  char text[32];
  const int size = std::snprintf(text, sizeof text, "%.*f", digits, value);
  return {text, static_cast<std::size_t>(size)};
}

/// Replaces white space, at which trec_eval splits.
std::string one_word(std::string text) {
  std::ranges::replace_if(text, [](char c) { return c == ' ' || c == '\t'; }, '_');
  return text;
}

/// The end of an IRI behind the last `#` or `/`.
std::string short_name(const std::string& iri) {
  const std::string name = base::printable(iri, 1000);
  const std::size_t cut = name.find_last_of("#/");
  return cut == std::string::npos || cut + 1 == name.size() ? name : name.substr(cut + 1);
}

/// The outputs or the inputs: their pairs, with the concepts of both.
struct Side {
  std::string_view name;
  double score;
  const std::vector<Pair>& pairs;
  const std::vector<Concept>& required;
  const std::vector<Concept>& offered;

  [[nodiscard]] std::size_t surplus() const {
    return offered.size() > required.size() ? offered.size() - required.size() : 0;
  }
};

Side outputs_of(const Described& request, const Described& service, const signature::Score& score) {
  return {"outputs", score.outputs, score.output_pairs, request.signature.outputs, service.signature.outputs};
}

Side inputs_of(const Described& request, const Described& service, const signature::Score& score) {
  return {"inputs", score.inputs, score.input_pairs, service.signature.inputs, request.signature.inputs};
}

std::string words(const Side& side, const ConceptNames& names) {
  std::string text = std::string(side.name) + ' ' + decimal(side.score, 3);
  const char* separator = ": ";
  for (const Pair& pair : side.pairs) {
    text += separator + short_name(names.iri(side.required[pair.required])) + " by ";
    text += pair.offered ? short_name(names.iri(side.offered[*pair.offered])) + ' ' +
                               std::string(to_string(pair.relation)) + ' ' + decimal(pair.value, 3)
                         : "nothing";
    separator = ", ";
  }
  if (side.surplus() > 0) text += separator + std::to_string(side.surplus()) + " not asked for";
  return text;
}

boost::json::object object(const Side& side, const ConceptNames& names) {
  boost::json::array pairs;
  for (const Pair& pair : side.pairs) {
    boost::json::object one{{"required", names.iri(side.required[pair.required])},
                            {"offered", nullptr},
                            {"relation", to_string(pair.relation)},
                            {"value", pair.value}};
    if (pair.offered) one["offered"] = names.iri(side.offered[*pair.offered]);
    pairs.push_back(std::move(one));
  }
  return {{"score", side.score}, {"pairs", std::move(pairs)}, {"surplus", side.surplus()}};
}

boost::json::array texts(const std::vector<std::string>& lines) {
  boost::json::array array;
  for (const std::string& line : lines) array.emplace_back(base::printable(line, 4096));
  return array;
}

}  // namespace

std::optional<RankFormat> find_rank_format(std::string_view name) {
  if (name == "text") return RankFormat::text;
  if (name == "json") return RankFormat::json;
  if (name == "trec") return RankFormat::trec;
  return std::nullopt;
}

std::string RankWriter::begin() const { return format_ == RankFormat::json ? "{\"requests\":[" : ""; }

std::string RankWriter::request(const Described& request, const std::vector<Ranked>& ranked) {
  if (format_ != RankFormat::json) return lines(request, ranked);
  std::string text = is_first_ ? "" : ",";
  is_first_ = false;
  return text + document(request, ranked);
}

std::string RankWriter::end() const {
  if (format_ != RankFormat::json) return {};
  const boost::json::object rest{{"services", collection_.services().size()},
                                 {"problems", texts(collection_.problems())},
                                 {"remarks", texts(collection_.remarks())}};
  return "]," + json_text(rest).substr(1) + '\n';
}

std::string RankWriter::lines(const Described& request, const std::vector<Ranked>& ranked) const {
  std::string text;
  for (std::size_t at = 0; at < ranked.size(); ++at) {
    const Described& service = collection_.services()[ranked[at].service];
    const std::string score = decimal(ranked[at].score.total, 9);
    const std::string place = std::to_string(at + 1);
    if (format_ == RankFormat::trec) {
      text += one_word(request.name) + " Q0 " + one_word(service.name) + ' ' + place + ' ' + score + " geminga\n";
      continue;
    }
    text += request.name + '\t' + place + '\t' + service.name + '\t' + score;
    if (has_reasons_)
      text += '\t' + words(outputs_of(request, service, ranked[at].score), collection_.names()) + "; " +
              words(inputs_of(request, service, ranked[at].score), collection_.names());
    text += '\n';
  }
  return text;
}

std::string RankWriter::document(const Described& request, const std::vector<Ranked>& ranked) const {
  boost::json::array services;
  for (std::size_t at = 0; at < ranked.size(); ++at) {
    const Described& service = collection_.services()[ranked[at].service];
    services.push_back(
        boost::json::object{{"rank", at + 1},
                            {"service", service.name},
                            {"score", ranked[at].score.total},
                            {"outputs", object(outputs_of(request, service, ranked[at].score), collection_.names())},
                            {"inputs", object(inputs_of(request, service, ranked[at].score), collection_.names())}});
  }
  return json_text(boost::json::object{{"request", request.name},
                                       {"file", base::printable(request.path, 4096)},
                                       {"inputs", texts(request.profile.inputs)},
                                       {"outputs", texts(request.profile.outputs)},
                                       {"services", std::move(services)}});
}

}  // namespace geminga::ontology
