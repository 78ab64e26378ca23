// A file is the same, and is refused for the same reason, whether one thread reads it and looks at it or two do.
#include "reasoning/syntax/file_reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/hash.hpp"

namespace geminga::syntax {
namespace {

constexpr std::size_t block = FileReading::block_bytes;

/// A file without a name, which is gone when it is closed.
class Anonymous {
 public:
  explicit Anonymous(std::string_view content) : file_(std::tmpfile(), std::fclose) {
    EXPECT_EQ(std::fwrite(content.data(), 1, content.size(), file_.get()), content.size());
    EXPECT_EQ(std::fseek(file_.get(), 0, SEEK_SET), 0);
  }
  [[nodiscard]] int descriptor() const { return fileno(file_.get()); }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// The words for how a file ends that is expected to have `size` octets and to begin with the content.
std::string reading_of(std::string_view content, std::size_t size, unsigned threads, std::size_t watched_bytes = 1) {
  const Anonymous file(content);
  const std::string path = "a.ttl";
  const FileLimits limits{.watched_bytes = watched_bytes};
  std::vector<char> memory(size);
  FileReading reading(path, file.descriptor(), memory.data(), size, limits);
  if (const auto error = reading.run(threads)) return to_string(*error);
  const std::string_view read(memory.data(), reading.size());
  if (read != content) return "other octets";
  return reading.hash() == base::hash64(content) ? "as it is" : "another hash";
}

/// Lines of Turtle of so many octets.
std::string lines(std::size_t octets) {
  constexpr std::string_view line = "<http://e/A> <http://e/p> \"some text\" .\n";
  std::string text;
  while (text.size() < octets) text += line;
  text.resize(octets, ' ');
  return text;
}

TEST(FileReading, GivesTheSameOctetsAndHashWhateverReadsThem) {
  for (const std::size_t size : {std::size_t{1}, block - 1, block, block + 1, 10 * block + 7}) {
    const std::string content = lines(size);
    for (const unsigned threads : {1U, 2U, 8U}) EXPECT_EQ(reading_of(content, size, threads), "as it is") << size;
  }
}

TEST(FileReading, RefusesATextThatIsTooLongWithItsLine) {
  // The text is longer than all that may be read before it is seen.
  const std::string before = "\n\n" + lines(block) + "\n";
  const auto ends = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::string content = before + "<a> <b> \"" + std::string(3 * FileReading::ahead_bytes, 'x') + "\" .\n";
  const std::string expected =
      "a.ttl:" + std::to_string(ends + 1) + ": has a literal of more than " + std::to_string(1 << 20) + " bytes";
  for (const unsigned threads : {1U, 2U}) EXPECT_EQ(reading_of(content, content.size(), threads), expected);
  EXPECT_EQ(reading_of(content, content.size(), 2, content.size()), "as it is") << "it is not watched";
}

TEST(FileReading, RefusesAFileThatBecameShorter) {
  const std::string content = lines(3 * block);
  for (const unsigned threads : {1U, 2U}) {
    EXPECT_EQ(reading_of(content, content.size() + 1, threads), "a.ttl: became shorter while it was read: try again");
  }
}

TEST(FileReading, NamesATextThatIsTooLongBeforeAnErrorBehindIt) {
  const std::string content = "<a> <b> \"" + std::string(4 * block, 'x');
  for (int round = 0; round < 5; ++round) {
    EXPECT_EQ(reading_of(content, content.size() + 1, 2),
              "a.ttl:1: has a literal of more than " + std::to_string(1 << 20) + " bytes");
  }
}

}  // namespace
}  // namespace geminga::syntax
