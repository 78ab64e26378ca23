// Records of an answer, chosen by a field.
#ifndef GEMINGA_ANSWERS_RECORDS_HPP
#define GEMINGA_ANSWERS_RECORDS_HPP

#include <string_view>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::answers {

/// The records that have this field.
[[nodiscard]] inline std::vector<Record> with_field(const Answer& answer, std::string_view key) {
  std::vector<Record> records = answer.records;
  std::erase_if(records, [&](const Record& record) { return record[key].empty(); });
  return records;
}

}  // namespace geminga::answers

#endif
