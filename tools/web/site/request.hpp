// One request, as far as its answer depends on it.
#ifndef GEMINGA_WEB_SITE_REQUEST_HPP
#define GEMINGA_WEB_SITE_REQUEST_HPP

#include <string>
#include <vector>

namespace geminga::web {

struct Request {
  std::string method;
  std::string target;
  std::vector<std::string> hosts{};           ///< the values of its `Host` fields
  std::vector<std::string> authorizations{};  ///< those of `Authorization`
  std::string accept{};                       ///< those of `Accept`, separated by commas
};

}  // namespace geminga::web

#endif
