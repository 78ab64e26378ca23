#include "reasoning/syntax/rdf/scan/rewrite.hpp"

#include <algorithm>

namespace geminga::rdf {

std::string rewritten(std::string_view text, std::vector<Rewrite> rewrites) {
  std::ranges::sort(rewrites, {}, &Rewrite::begin);
  std::string out;
  std::size_t copied = 0;
  for (const Rewrite& one : rewrites) {
    out += text.substr(copied, one.begin - copied);
    out += one.text;
    copied = one.begin + one.size;
  }
  return out += text.substr(copied);
}

}  // namespace geminga::rdf
