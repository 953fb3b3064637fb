// SPDX-License-Identifier: GPL-3.0-or-later
// planted_faults PAGE: switches on each fault of slide and of the readers, and counts the inputs of a fuzz
// target, always with the same random numbers, until it finds the fault. The page must say how many.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "properties/compare/corpus.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "properties/fuzz/pair_of_bytes.hpp"
#include "properties/fuzz/slide_check.hpp"
#include "properties/fuzz/text_mutation.hpp"
#include "properties/mutants/mutants.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/io/file_text.hpp"

namespace oplus {
namespace {

constexpr std::size_t pairs = 4000, texts = 6000;

/// Runs input after input. One that is wrong throws, crashes or does not end.
using Inputs = std::function<void(std::size_t)>;

/// As libFuzzer begins: from the corpus, a few bytes other ones; or any bytes.
std::string next_bytes(Random& random, const std::vector<std::string>& pool) {
  const auto any_byte = [&] { return static_cast<char>(uniform(random, 0, 255)); };
  std::string bytes(32, '\0');
  if (one_in(random, 2)) {
    for (char& byte : bytes) byte = any_byte();
    return bytes;
  }
  bytes = pool[uniform_index(random, pool.size())];
  for (int changes = uniform(random, 1, 3); changes > 0; --changes)
    bytes[uniform_index(random, bytes.size())] = any_byte();
  return bytes;
}

/// The inputs of slide, with what is right, which no fault of slide changes.
Inputs inputs_of_slide() {
  struct Known {
    Summands pair;
    ExpectedSums sums;
    SlideLaws laws;
  };
  auto known = std::make_shared<std::vector<Known>>();
  Random random(1);
  std::vector<std::string> pool;
  for (const CorpusPair& row : corpus())
    if (const auto input = bytes_of_pair({row.p, row.q})) pool.push_back(*input);
  while (known->size() < pairs) {
    const std::string bytes = next_bytes(random, pool);
    const auto pair = pair_of_bytes(bytes);
    if (!pair) continue;
    pool.push_back(bytes);
    known->push_back({*pair, expected_sums(*pair), laws_for(bytes)});
  }
  return [known](std::size_t i) {
    const Known& input = known->at(i);
    check_slide(input.pair, input.sums, input.laws);
  };
}

Inputs inputs_of(const FuzzTarget& target) {
  auto all = std::make_shared<std::vector<std::string>>();
  Random random(1);
  while (all->size() < texts)
    all->push_back(target.mutated(
        random, one_in(random, 4) || all->empty()
                    ? new_sum_text(random, Format::wkt)
                    : all->at(all->size() - 1 -
                              uniform_index(random, std::min<std::size_t>(all->size(), 50)))));
  return [all, &target](std::size_t i) { target.run(all->at(i)); };
}

/// Tries the inputs; a mark in `output` before each. Returns whether none is wrong.
bool none_is_wrong(const std::string& fault, const Inputs& inputs, std::size_t most, int output) {
#ifdef OPLUS_MUTANTS
  active_mutant = fault;
#endif
  try {
    for (std::size_t i = 0; i < most; ++i) {
      alarm(60);
      if (::write(output, "\n", 1) != 1) return false;
      inputs(i);
    }
  } catch (const std::exception& e) {
    if (fault.empty()) std::cerr << "without a fault: " << e.what() << '\n';
    return false;
  }
  return true;
}

/// How many inputs it takes in a process of its own, which has the inputs already, and in which a fault may
/// crash or hang; one more than `most` where none is wrong.
std::size_t inputs_until_found(const std::string& fault, const Inputs& inputs, std::size_t most) {
  std::cout.flush();
  std::array<int, 2> marks{};
  if (::pipe(marks.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t process = ::fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process == 0) ::_exit(none_is_wrong(fault, inputs, most, marks[1]) ? 0 : 1);
  ::close(marks[1]);
  std::size_t tried = 0;
  std::array<char, 4096> read{};
  for (ssize_t count = 0; (count = ::read(marks[0], read.data(), read.size())) > 0;)
    tried += static_cast<std::size_t>(count);
  ::close(marks[0]);
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? most + 1 : tried;
}

struct Stream {
  const FuzzTarget* target;
  Inputs inputs;
  std::size_t most;
};

/// A row of the table; empty where no target finds the fault.
std::string row(const Mutant& fault, const std::vector<Stream>& streams) {
  const Stream* best = nullptr;
  std::size_t least = 0;
  for (const Stream& stream : streams) {
    const std::size_t count = inputs_until_found(fault.name, stream.inputs, stream.most);
    if (count > stream.most || (best != nullptr && count >= least)) continue;
    best = &stream;
    least = count;
  }
  if (best == nullptr) return "";
  return "| `" + fault.name + "`: " + fault.what + " | `" + best->target->name + "` | " +
         std::to_string(least) + " |";
}

int run(const std::string& page_file) {
  const std::string page = text_of_file(page_file, "the page on fuzzing");
  const std::vector<Stream> of_slide = {{&slide_target, inputs_of_slide(), pairs}};
  std::vector<Stream> of_readers;
  for (const FuzzTarget* target : {&dat_target, &wkt_target, &geojson_target, &sums_target})
    of_readers.push_back({target, inputs_of(*target), texts});
  int wrong = 0;
  const auto fail = [&](const std::string& what) {
    std::cout << what << '\n';
    ++wrong;
  };
  for (const std::vector<Stream>& streams : {of_slide, of_readers})
    for (const Stream& stream : streams)
      if (inputs_until_found("", stream.inputs, stream.most) <= stream.most)
        fail(std::string(stream.target->name) + " finds something where there is no fault");
  for (const Mutant& fault : mutants()) {
    // No target has texts of these forms; fact-forms-of-input names their faults.
    if (fault.file == "reference/io/svg_path_reading.cpp" ||
        fault.file == "reference/io/wkb_reading.cpp")
      continue;
    const bool of_a_reader = fault.file.starts_with("reference/io/");
    const bool of_slide_too = fault.name == "touching-points-are-not-tested";
    // The target computes each sum once, so that nothing is prepared, and no depth.
    if (fault.file == "checked/slide/kept_summands.hpp" ||
        fault.name.starts_with("nearest-boundary-"))
      continue;
    if (!of_a_reader && !of_slide_too && !fault.file.starts_with("checked/slide/")) continue;
    const std::string line = row(fault, of_a_reader ? of_readers : of_slide);
    if (line.empty())
      fail("not found: " + fault.name);
    else if (page.find(line + '\n') == std::string::npos)
      fail(page_file + " lacks this row:\n" + line);
    else
      std::cout << line << '\n';
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace oplus

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: planted_faults PAGE\n";
    return 2;
  }
#ifdef OPLUS_MUTANTS
  return oplus::run(argv[1]);
#else
  (void)&oplus::run;
  (void)argv;
  std::cerr << "this build contains no faults; use the preset check\n";
  return 2;
#endif
}
