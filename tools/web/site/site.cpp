#include "web/site/site.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "web/site/api.hpp"
#include "web/site/event_stream.hpp"
#include "web/site/health.hpp"
#include "web/site/page.hpp"

namespace geminga::web {
namespace {

constexpr std::string_view api = "/api/";

/// The answers to several questions, of which some are still to come.
struct Gathered {
  std::vector<Outcome> outcomes;
  std::size_t missing = 0;
};

/// The words between commas.
std::vector<std::string> words_of(std::string_view list) {
  std::vector<std::string> words;
  for (const auto word : std::views::split(list, ',')) words.emplace_back(word.begin(), word.end());
  return words;
}

/// Whether these are kinds of listings, each named once.
bool are_watched(const std::vector<std::string>& kinds) {
  for (const std::string& kind : kinds) {
    if (key_of(kind).empty() || std::ranges::count(kinds, kind) > 1) return false;
  }
  return !kinds.empty();
}

Response live_page() {
  return {.type = "text/html; charset=utf-8",
          .body = std::string(page),
          .fields = {{"Content-Security-Policy", std::string(page_policy) + "; frame-ancestors 'none'"}}};
}

}  // namespace

void Site::answer(const Request& request, const Then& then) {
  const Then counted = [this, then](Response response) {
    count(response.status);
    if (response.stream) ++traffic_.streams;
    then(std::move(response));
  };
  if (auto refusal = refuse(request, rules_)) return counted(std::move(*refusal));
  const auto target = read_target(request.target);
  if (!target) return counted(failure(400, target.error()));
  route(request, *target, counted);
}

void Site::route(const Request& request, const Target& target, const Then& then) {
  const std::string_view path = target.path;
  if (path == api.substr(0, api.size() - 1) || path == api) {
    return then(failure(404, "name a question: /api/status and its like, or /api/events"));
  }
  if (path == "/api/events") return answer_events(target.parameters, then);
  if (path == "/api/doctor" && examine_) return answer_doctor(target.parameters, then);
  if (path == "/api/alerts") {
    if (!target.parameters.empty()) return then(failure(400, "no parameters go with " + target.path));
    return then(document(alerting_ == nullptr ? boost::json::array() : alerting_->document()));
  }
  if (path == "/api/history") {
    if (!target.parameters.empty()) return then(failure(400, "no parameters go with " + target.path));
    return then({.type = "application/json", .body = history_.document() + '\n'});
  }
  if (path.starts_with(api)) return answer_question(path.substr(api.size()), target.parameters, then);
  if (path != "/" && path != open_path && path != "/readyz" && path != "/metrics") {
    return then(failure(404, "there is no such page: there are /, /metrics, /livez, /readyz and /api/"));
  }
  if (!target.parameters.empty()) return then(failure(400, "no parameters go with " + target.path));
  if (path == "/") return then(live_page());
  if (path == open_path) return then(plain(200, "ok"));
  if (path == "/readyz") return answer_readiness(then);
  answer_metrics(form_for(request.accept), then);
}

void Site::answer_readiness(const Then& then) {
  asker_.ask({"status"}, [then](const Outcome& status) {
    const std::string reason = unreadiness(*status);
    then(reason.empty() ? plain(200, "ok") : plain(503, reason));
  });
}

void Site::answer_metrics(Form form, const Then& then) {
  const auto gathered = std::make_shared<Gathered>();  // lives as long as one answer is missing
  const auto& questions = metric_questions();
  gathered->outcomes.resize(questions.size());
  gathered->missing = questions.size();
  for (std::size_t at = 0; at < questions.size(); ++at) {
    asker_.ask(questions[at], [this, form, then, gathered, at](const Outcome& outcome) {
      gathered->outcomes[at] = outcome;
      if (--gathered->missing > 0) return;
      auto families = metrics(gathered->outcomes, traffic_);
      if (alerting_ != nullptr && alerting_->has_rules()) {
        for (Family& family : alerting_->families()) families.push_back(std::move(family));
      }
      then({.type = std::string(media_type(form)), .body = exposition(families, form)});
    });
  }
}

void Site::answer_question(std::string_view kind, const Parameters& parameters, const Then& then) {
  auto query = read_question(kind, parameters);
  if (!query) return then(std::move(query.error()));
  asker_.ask(*query, [query = *query, then](const Outcome& outcome) {
    then(outcome->has_value() ? document(document_of(query, outcome->value())) : failure_of(outcome->error()));
  });
}

void Site::answer_doctor(const Parameters& parameters, const Then& then) {
  if (!parameters.empty()) return then(failure(400, "no parameters go with /api/doctor"));
  examine_([then](const Result<boost::json::value, ClientError>& examined) {
    then(examined ? document(*examined) : failure_of(examined.error()));
  });
}

void Site::answer_events(const Parameters& parameters, const Then& then) {
  Parameters rest = parameters;
  const auto of = std::ranges::find(rest, "of", &Parameters::value_type::first);
  const std::vector<std::string> kinds = of == rest.end() ? std::vector<std::string>() : words_of(of->second);
  if (!are_watched(kinds)) {
    return then(failure(400,
                        "say of what: of=match, or of=participants, services or requests, or several of these, "
                        "as in of=participants,services"));
  }
  rest.erase(of);
  std::vector<Query> queries;
  for (const std::string& kind : kinds) {
    if (kinds.size() > 1 && !rest.empty()) return then(failure(400, "keys of a question go with one kind"));
    auto query = read_question(kind, rest);
    if (!query) return then(std::move(query.error()));
    queries.push_back(std::move(*query));
  }
  // The first answer shows whether the daemon understands the question.
  const Query first = queries.front();
  asker_.ask(first, [this, queries = std::move(queries), then](const Outcome& outcome) {
    const bool is_refused = !outcome->has_value() && (outcome->error().kind == ClientError::Kind::wrong_use ||
                                                      outcome->error().kind == ClientError::Kind::refused);
    if (is_refused) return then(failure_of(outcome->error()));
    then({.type = "text/event-stream", .stream = std::make_shared<EventStream>(asker_, queries)});
  });
}

}  // namespace geminga::web
