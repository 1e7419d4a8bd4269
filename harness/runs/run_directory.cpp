#include "harness/runs/run_directory.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "harness/charts/chart.h"
#include "harness/measure/environment.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

void create_new_directory(const std::filesystem::path& directory) {
  std::error_code error;
  if (std::filesystem::exists(directory, error))
    throw std::invalid_argument(
        fmt::format("{} exists: name a new directory, or move it aside", directory.string()));
  std::filesystem::create_directories(directory, error);
  if (error)
    throw UnwritableOutput(
        fmt::format("{}: cannot create: {}", directory.string(), error.message()));
}

/// Does what writes rows, turning the system's refusal into an UnwritableOutput.
template <class Write>
auto writing_rows(Write write) {
  try {
    return write();
  } catch (const std::system_error& error) {
    throw UnwritableOutput(error.what());
  }
}

}  // namespace

std::size_t run_into(const std::filesystem::path& directory, RunPlan plan,
                     const std::function<void(const Progress&)>& progress,
                     const std::atomic<bool>& interrupted) {
  create_new_directory(directory);
  const nlohmann::json environment = describe_environment(plan.jobs);
  plan.environment = environment.at("id").get<std::string>();
  replace_file((directory / "env.json").string(), environment.dump(1) + "\n");
  const auto writer =
      writing_rows([&] { return std::make_unique<RecordWriter>(directory.string()); });
  std::size_t rows = 0;
  run(
      plan,
      [&](const Record& record) {
        writing_rows([&] { writer->write(record); });
        ++rows;
      },
      progress, interrupted);
  return rows;
}

std::vector<Record> read_run(const std::filesystem::path& directory) {
  try {
    return read_records(directory.string());
  } catch (const std::runtime_error& error) {
    throw UnreadableInput(error.what());
  }
}

Table write_tables(const std::filesystem::path& directory) {
  const Table table = make_table(read_run(directory));
  const auto write = [&](const char* name, TableFormat format) {
    replace_file((directory / name).string(), render(table, format));
  };
  write("table.txt", TableFormat::text);
  write("table.csv", TableFormat::csv);
  write("table.json", TableFormat::json);
  return table;
}

void write_chart(const std::filesystem::path& directory) {
  const std::vector<Record> records = read_run(directory);
  const std::vector<ChartPoint> points = chart_points(records);
  if (std::any_of(points.begin(), points.end(), [](const ChartPoint& p) { return p.counted > 0; }))
    draw_chart(points, records.front().tolerance, directory / "chart.svg");
}

}  // namespace lcp
