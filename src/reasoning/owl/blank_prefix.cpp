#include "reasoning/owl/blank_prefix.hpp"

#include "base/hash.hpp"
#include "base/text.hpp"

namespace geminga::owl {

std::string blank_prefix_of(std::string_view octets) { return "_:" + base::to_hex(base::hash64(octets), 16) + '.'; }

}  // namespace geminga::owl
