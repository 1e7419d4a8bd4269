#include "harness/charts/chart.h"

#include <fmt/format.h>

#include <map>
#include <tuple>

#include "harness/charts/chart_script.h"
#include "harness/charts/gnuplot.h"
#include "harness/observed_quantile.h"
#include "harness/tables/table.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

std::optional<Spread> spread(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return Spread{*observed_quantile(values, 0.25), *observed_quantile(values, 0.5),
                *observed_quantile(values, 0.75)};
}

/// The values behind one point.
struct Samples {
  std::vector<double> times_ms;
  std::vector<double> residuals;
};

}  // namespace

std::vector<ChartPoint> chart_points(const std::vector<Record>& records) {
  std::map<std::tuple<std::string, std::string, std::string>, Samples> samples;
  for (const Record& record : records) {
    if (record.verdict != Verdict::solved || record.trivial) continue;
    Samples& of = samples[{record.corpus, record.solver, record.start}];
    if (const auto time = record.median_ns())
      of.times_ms.push_back(1e-6 * static_cast<double>(*time));
    of.residuals.push_back(record.accuracy.value().residual);
  }
  std::map<std::string, std::string> row_of;
  for (const Record& record : records) row_of[record.solver] = record.row;

  std::vector<ChartPoint> points;
  const Table table = make_table(records);
  for (const TableRow& row : table.rows) {
    const Samples& of = samples[{row.corpus, row.solver, row.start}];
    std::string name = row_of[row.solver];
    if (table.several_starts) name += fmt::format(" [{}]", row.start);
    points.push_back({row.corpus, name, row.label, row.success + row.failure, row.failure,
                      spread(of.times_ms), spread(of.residuals)});
  }
  return points;
}

void draw_chart(const std::vector<ChartPoint>& points, double tolerance,
                const std::filesystem::path& svg) {
  const ChartFiles files = chart_files(points, tolerance, svg.stem().string());
  const std::filesystem::path gp = std::filesystem::path(svg).replace_extension(".gp");
  replace_file(std::filesystem::path(svg).replace_extension(".dat").string(), files.data);
  replace_file(gp.string(), files.script);
  run_gnuplot(gp, svg);
}

}  // namespace lcp
