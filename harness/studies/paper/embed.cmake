# Writes OUTPUT, a header that holds the text of the file INPUT as the string NAME.
file(READ ${INPUT} text)
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [=[
#pragma once

namespace lcp {

inline constexpr const char* @NAME@ = R"embedded(@text@)embedded";

}  // namespace lcp
]=])
