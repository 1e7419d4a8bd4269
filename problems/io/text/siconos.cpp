#include "problems/io/text/siconos.h"

#include <array>
#include <charconv>
#include <stdexcept>

#include "problems/io/errors.h"
#include "problems/io/limits.h"
#include "problems/io/local_contacts.h"
#include "problems/io/text/read_text.h"
#include "problems/io/text/siconos_matrix.h"

namespace lcp {

namespace {

enum class Kind { lcp, friction_contact, unknown };

Index integer_or_minus_one(std::string_view word) {
  Index number = -1;
  const char* end = word.data() + word.size();
  return std::from_chars(word.data(), end, number).ptr == end ? number : -1;
}

/// LCP: n, storage, n, n. Friction contact: d, Nc, storage, d Nc, d Nc. Both can begin with
/// 2 1 2 2 2: n = 2 in two blocks, or one compressed contact in the plane, which names CSparse.
Kind kind_of(Scanner& file) {
  std::array<Index, 5> head{};
  for (int i = 0; i < 5; ++i)
    head[static_cast<std::size_t>(i)] = integer_or_minus_one(file.peek(i));
  const auto is_storage = [](Index number) { return number >= 0 && number <= 2; };
  const bool lcp = head[0] > 0 && is_storage(head[1]) && head[2] == head[0] && head[3] == head[0];
  const bool contacts = (head[0] == 2 || head[0] == 3) && head[1] > 0 && head[1] <= largest_rows &&
                        is_storage(head[2]) && head[3] == head[0] * head[1] && head[4] == head[3];
  if (lcp && contacts) return file.peek(6) == "CSparse" ? Kind::friction_contact : Kind::lcp;
  return lcp ? Kind::lcp : contacts ? Kind::friction_contact : Kind::unknown;
}

void require_end(Scanner& file) {
  if (file.number_follows()) file.fail("the end of the numbers");
}

Instance read_lcp(Scanner& file, const std::string& name,
                  std::map<std::string, std::string> provenance, const std::string& path) {
  const Index n = file.integer("n", 1, largest_rows);
  SiconosMatrix matrix = read_siconos_matrix(file, n);
  Problem problem;
  problem.M = std::move(matrix.numbers);
  problem.q = file.numbers("q", n);
  require_end(file);
  provenance["format"] = "Siconos LCP";
  provenance["storage"] = siconos_storage_name(matrix.storage);
  try {
    return make_instance(name, std::move(problem), std::move(provenance));
  } catch (const std::invalid_argument& error) {
    throw UnreadableInput("{}: {}", path, error.what());
  }
}

Instance read_contacts(Scanner& file, const std::string& name, const ReadOptions& options,
                       std::map<std::string, std::string> provenance, const std::string& path) {
  LocalContacts local;
  local.dimension = file.integer("dimension", 2, 3);
  const Index contacts = file.integer("contacts", 1, largest_rows);
  require_readable_size(contacts, local.dimension, options, path);
  SiconosMatrix matrix = read_siconos_matrix(file, local.dimension * contacts);
  local.W = std::move(matrix.numbers);
  local.q = file.numbers("q", local.dimension * contacts);
  local.mu = file.numbers("mu", contacts);
  if (file.peek() != "1") {
    if (file.peek() == "0") file.require("0");
    require_end(file);
  }
  provenance["format"] = "Siconos friction contact";
  provenance["storage"] = siconos_storage_name(matrix.storage);
  return contact_instance(name, std::move(local), options, std::move(provenance), path);
}

}  // namespace

Instance read_siconos(const std::string& path, const std::string& name,
                      const ReadOptions& options) {
  const std::string text = read_text(path, "a Siconos file", longest_file);
  Scanner file(path, text);
  const std::map<std::string, std::string> provenance{{"file", path}};
  switch (kind_of(file)) {
    case Kind::lcp:
      return read_lcp(file, name, provenance, path);
    case Kind::friction_contact:
      return read_contacts(file, name, options, provenance, path);
    case Kind::unknown:
      break;
  }
  file.fail(
      "the head of an LCP (n, storage 0 ... 2, n, n) or of a friction-contact problem (dimension d "
      "= 2 or 3, contacts Nc, storage 0 ... 2, d Nc, d Nc)");
}

}  // namespace lcp
