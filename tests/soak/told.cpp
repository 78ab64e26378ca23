#include "soak/told.hpp"

#include <string_view>

#include "support/talk.hpp"

namespace geminga::soak {

void Told::hear(const std::string& line) {
  const std::size_t end_of_id = line.find(' ');
  if (end_of_id == std::string::npos) return;
  const std::string_view event = std::string_view(line).substr(end_of_id);
  const std::pair service{line.substr(0, end_of_id), system::field(line, "service")};
  if (event.starts_with(" pub add ")) {
    if (!services_.insert(service).second) faults_.push_back("told twice: " + line);
  } else if (event.starts_with(" pub del ")) {
    if (services_.erase(service) == 0) faults_.push_back("gone without having come: " + line);
  }
}

}  // namespace geminga::soak
