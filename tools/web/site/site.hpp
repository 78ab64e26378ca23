// The site: which path is answered how.
#ifndef GEMINGA_WEB_SITE_SITE_HPP
#define GEMINGA_WEB_SITE_SITE_HPP

#include <boost/json/value.hpp>
#include <functional>

#include "web/asking/asker.hpp"
#include "web/site/alerting.hpp"
#include "web/site/gate.hpp"
#include "web/site/history.hpp"
#include "web/site/metrics.hpp"
#include "web/site/request.hpp"
#include "web/site/response.hpp"
#include "web/site/target.hpp"

namespace geminga::web {

/// `/`, `/livez`, `/readyz`, `/metrics`, `/api/KIND`, `/api/doctor`, `/api/events?of=KIND`, `/api/history` and
/// `/api/alerts`. Knows no
/// sockets. Neither copies nor moves.
class Site {
 public:
  using Then = std::function<void(Response)>;

  /// Gives the document of the doctor later, or why there is none.
  using Examine = std::function<void(std::function<void(const Result<boost::json::value, ClientError>&)>)>;

  /// Borrows the asker, the history and the alerts. Without `examine` there is no doctor, and `alerting` may be null.
  Site(Asker& asker, const History& history, Rules rules, Examine examine = {}, const Alerting* alerting = nullptr)
      : asker_(asker), history_(history), rules_(std::move(rules)), examine_(std::move(examine)), alerting_(alerting) {}
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;

  /// Calls `then` once with the response, perhaps before it returns. That to HEAD is the response to GET, body
  /// included.
  void answer(const Request& request, const Then& then);
  /// Counts a response that was made without the site, too.
  void count(unsigned status) { ++traffic_.responses[status]; }

 private:
  void route(const Request& request, const Target& target, const Then& then);
  void answer_readiness(const Then& then);
  void answer_metrics(Form form, const Then& then);
  void answer_question(std::string_view kind, const Parameters& parameters, const Then& then);
  void answer_events(const Parameters& parameters, const Then& then);
  void answer_doctor(const Parameters& parameters, const Then& then);

  Asker& asker_;
  const History& history_;
  Rules rules_;
  Examine examine_;
  const Alerting* alerting_;
  Traffic traffic_;
};

}  // namespace geminga::web

#endif
