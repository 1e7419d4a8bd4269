# Writes OUTPUT, a header that says which commit of SOURCE is being built and whether its tracked
# files differ from it. The file is left alone when nothing changed, so that nothing is recompiled.
execute_process(COMMAND git -C ${SOURCE} rev-parse HEAD
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
                RESULT_VARIABLE failed ERROR_QUIET)
execute_process(COMMAND git -C ${SOURCE} status --porcelain --untracked-files=no
                OUTPUT_VARIABLE changes RESULT_VARIABLE status_failed ERROR_QUIET)
if(failed OR status_failed)
  set(commit unknown)
  set(dirty std::nullopt)
elseif(changes)
  set(dirty true)
else()
  set(dirty false)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#pragma once

#include <optional>

namespace lcp {

inline constexpr const char* build_commit = "@commit@";
inline constexpr std::optional<bool> build_is_dirty = @dirty@;  // Empty: git cannot tell.

}  // namespace lcp
]])
