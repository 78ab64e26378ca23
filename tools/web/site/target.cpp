#include "web/site/target.hpp"

#include <algorithm>
#include <boost/url/parse.hpp>
#include <boost/url/url_view.hpp>

#include "base/text.hpp"
#include "web/site/limits.hpp"

namespace geminga::web {
namespace {

bool is_clean(std::string_view text) {
  return base::is_valid_utf8(text) &&
         std::ranges::none_of(text, [](char c) { return (static_cast<unsigned char>(c) < 0x20) || c == 0x7f; });
}

}  // namespace

std::expected<Target, std::string> read_target(std::string_view text) {
  const auto url = boost::urls::parse_origin_form(text);
  if (!url) return std::unexpected("the target is no path: write /PATH?KEY=VALUE");
  Target target{.path = url->path()};
  boost::urls::encoding_opts options;
  options.space_as_plus = true;
  for (const auto& parameter : url->params(options)) target.parameters.emplace_back(parameter.key, parameter.value);
  if (target.parameters.size() > max_target_parameters) {
    return std::unexpected("the target has over " + std::to_string(max_target_parameters) + " parameters");
  }
  const bool is_text = is_clean(target.path) && std::ranges::all_of(target.parameters, [](const auto& one) {
                         return is_clean(one.first) && is_clean(one.second);
                       });
  if (!is_text) return std::unexpected("the target is no text: write UTF-8 without control characters");
  return target;
}

}  // namespace geminga::web
