#pragma once

#include <string>

namespace lcp {

/// Throws UnreadableInput, naming `path` and the line, unless `text` is a Matrix Market file (real or
/// integer, coordinate or array) of at most `largest_rows` rows and columns with as many entries as
/// it declares. It leaves CHOLMOD only what that reads without fault: CHOLMOD allocates what the size
/// line says, makes up numbers for entries without a value, takes rows that count from 0, and loses
/// memory on indices out of range and missing lines.
void check_matrix_market_text(const std::string& path, const std::string& text);

}  // namespace lcp
