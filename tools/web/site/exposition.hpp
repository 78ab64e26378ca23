// Metrics as text for Prometheus: OpenMetrics 1.0, and the older form that promtool reads.
#ifndef GEMINGA_WEB_SITE_EXPOSITION_HPP
#define GEMINGA_WEB_SITE_EXPOSITION_HPP

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geminga::web {

using Labels = std::vector<std::pair<std::string, std::string>>;

/// One value. It is written as it stands, so that no number changes on its way.
struct Sample {
  Labels labels;
  std::string value;
};

/// A metric with its samples.
struct Family {
  enum class Type : std::uint8_t { gauge, counter, info };
  std::string name;  ///< without `_total` and `_info`; it ends in the unit
  Type type = Type::gauge;
  std::string unit;  ///< empty: none
  std::string help;  ///< a sentence without its full stop
  std::vector<Sample> samples{};
};

enum class Form : std::uint8_t {
  openmetrics,  ///< OpenMetrics 1.0.0: types, units, `# EOF`
  plain,        ///< Prometheus's own text format, 0.0.4
};

/// The form that an `Accept` field asks for: OpenMetrics, unless it names text/plain and no OpenMetrics.
[[nodiscard]] Form form_for(std::string_view accept);
/// The media type of a form.
[[nodiscard]] std::string_view media_type(Form form);

/// The families that have samples, in their order.
[[nodiscard]] std::string exposition(const std::vector<Family>& families, Form form);

}  // namespace geminga::web

#endif
