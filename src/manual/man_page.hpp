// A page of the manual in roff, with the macros of man(7).
#ifndef GEMINGA_MANUAL_MAN_PAGE_HPP
#define GEMINGA_MANUAL_MAN_PAGE_HPP

#include <string>

#include "manual/outline.hpp"

namespace geminga::manual {

/// The page in ASCII, with a line end at its end. `section` as in described(); `date` as in 2026-11-23.
[[nodiscard]] std::string man_page(const Outline& program, int section, const std::string& date);

}  // namespace geminga::manual

#endif
