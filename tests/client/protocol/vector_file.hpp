// The rows of tests/client/vectors, which all languages pass.
#ifndef GEMINGA_TESTS_CLIENT_PROTOCOL_VECTOR_FILE_HPP
#define GEMINGA_TESTS_CLIENT_PROTOCOL_VECTOR_FILE_HPP

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace geminga::client {

inline std::vector<std::byte> from_hex(const std::string& hex) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::byte>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

/// The fields of each row that is no comment, at least `fields` of them.
inline std::vector<std::vector<std::string>> vector_rows(const std::string& name, std::size_t fields) {
  std::ifstream file(std::string(GEMINGA_SOURCE_DIR) + "/tests/client/vectors/" + name);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string> row;
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, '\t');) row.push_back(word);
    if (row.size() < fields) row.resize(fields);
    rows.push_back(std::move(row));
  }
  return rows;
}

inline std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace geminga::client

#endif
