// The live page (tools/web/page), made a constant by the build.
#ifndef GEMINGA_WEB_SITE_PAGE_HPP
#define GEMINGA_WEB_SITE_PAGE_HPP

#include <string_view>

namespace geminga::web {

/// The page, one document of HTML that names no other.
extern const std::string_view page;
/// The Content-Security-Policy that admits its script and its style by their hashes, and nothing else inline.
extern const std::string_view page_policy;

}  // namespace geminga::web

#endif
