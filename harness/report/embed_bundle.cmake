# Writes OUTPUT, a header with the bytes of SCRIPT and STYLE as arrays: a literal may hold 64 kB only,
# and what is in them needs no escape.
function(as_array file name result)
  file(READ ${file} bytes HEX)
  string(LENGTH "${bytes}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(REGEX REPLACE "((......,)(......,)(......,)(......,)(......,)(......,)(......,)(......,))"
         "\\1\n" bytes "${bytes}")
  set(${result}
      "inline constexpr char ${name}_bytes[] = {\n${bytes}};\ninline constexpr std::size_t ${name}_size = ${size};\n"
      PARENT_SCOPE)
endfunction()

as_array(${SCRIPT} report_script script)
as_array(${STYLE} report_style style)
file(WRITE ${OUTPUT} "#pragma once\n\n#include <cstddef>\n\nnamespace lcp {\n\n${script}\n${style}\n}  // namespace lcp\n")
