#pragma once

#include <string>
#include <vector>

#include "problems/instance.h"

namespace lcp {

/// Instances as JSON, one object or several:
///
///     {"M": [[2, 1], [1, 2]], "q": [-5, -6]}
///     {"instances": [{"name": "a/1", "M": ..., "q": ...}, ...]}
///
/// An instance holds M (n rows of n numbers) and q (n). It may hold name, s_z, s_w (n; plain scales
/// otherwise), c (n), pivot_limit, known_solution (n), active_contacts, provenance (an object of
/// texts), previous_alpha and previous_z (the solution of the frame before, in these rows), sha256 and
/// previous_sha256 (which then have to agree), and friction, an object with the fields of
/// FrictionBlocks: W, vbar, mu, directions (2 rows), directions_per_contact, normal_row,
/// friction_row, cone_row. Other keys are refused, so that a misspelt one is noticed. Numbers are
/// written in decimals that read back as the same bits, -0 too.
inline constexpr const char* json_ending = ".json";

/// Bytes of the largest JSON file: in memory a number takes ten times the two bytes it may have
/// there.
inline constexpr std::size_t largest_json = std::size_t{256} << 20;

/// Reads the instances of a file; one without a name is called `unnamed`. Throws UnreadableInput
/// `file: /instances/3/M/2: has 4 entries, expected 5` on other types, shapes and keys, on numbers
/// that are not finite, on what is nested deeper than an instance is, on more than largest_rows rows
/// and largest_json bytes, and on two instances of one name.
std::vector<Instance> read_json(const std::string& path, const std::string& unnamed);

/// Replaces `path` by these instances, as {"instances": [...]}. Throws UnwritableOutput when the text
/// would be longer than largest_json or cannot be written, or a text is no UTF-8.
void write_json(const std::string& path, const std::vector<Instance>& instances);

}  // namespace lcp
