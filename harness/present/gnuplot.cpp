#include "harness/present/gnuplot.h"

#include <fmt/format.h>

#include <string>
#include <system_error>

#include "problems/io/child_process.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"

namespace lcp {

void run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& output) {
  const std::filesystem::path directory = std::filesystem::absolute(script).parent_path();
  const std::string file = script.filename().string();
  const std::string what = fmt::format("{}: cannot draw", output.string());
  ProgramOutput drawn;
  try {
    drawn = output_of("gnuplot", {file}, directory);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::no_such_file_or_directory)
      throw UnwritableOutput(
          fmt::format("{}: gnuplot is not installed (Debian: gnuplot-nox); once it is: "
                      "cd {} && gnuplot {} > {}",
                      what, directory.string(), file, output.filename().string()));
    throw UnwritableOutput(fmt::format("{}: gnuplot: {}", what, error.code().message()));
  }
  if (drawn.status != 0)
    throw UnwritableOutput(fmt::format("{}: gnuplot: {}", what, drawn.complaint));
  replace_file(output.string(), drawn.out);
}

}  // namespace lcp
