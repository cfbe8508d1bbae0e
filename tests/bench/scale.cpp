// How the campaign's costs grow with the number of jobs in one database: scale.csv and scale.svg.
// Usage: eerie_scale FOLDER [LARGEST]

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "analysis/drawing/gnuplot.hpp"
#include "campaign/manager/manager.hpp"
#include "campaign/manager/request.hpp"
#include "campaign/sweeps/sweep.hpp"
#include "campaign/worker/worker.hpp"
#include "db/jobs/control.hpp"
#include "solver/base/file.hpp"
#include "tests/bench/csv_block.hpp"
#include "tests/campaign/job_folder/job_files.hpp"
#include "tests/db/jobs/sample_jobs.hpp"
#include "tests/io/snapshot_fixture.hpp"
#include "tests/support/program.hpp"

namespace eerie {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

double seconds_of(const std::function<void()>& body) {
  const auto start = Clock::now();
  body();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The shortest of several tries.
double least_of(int tries, const std::function<void()>& body) {
  double least = 1e300;
  for (int i = 0; i < tries; ++i) least = std::min(least, seconds_of(body));
  return least;
}

/// A sweep of n jobs: seeds by speeds.
void write_sweep(const fs::path& file, const std::string& name, int jobs, double end_time_s) {
  json seeds = json::array(), speeds = json::array();
  const int of_speeds = std::min(jobs, 100);
  for (int i = 0; i < of_speeds; ++i) speeds.push_back(10 + 0.25 * i);
  for (int i = 0; i < jobs / of_speeds; ++i) seeds.push_back(i);
  install_text(
      file,
      json{{"name", name},
           {"scene",
            {{"numerics", {{"particles_per_target", 100}}}, {"end", {{"time_s", end_time_s}}}}},
           {"grid", {{"v_imp_cm_per_s", speeds}, {"numerics.seed", seeds}}}}
          .dump());
}

/// Half of the jobs are done, as in the middle of a campaign.
void finish_half(const fs::path& database) {
  db::Connection connection(database, db::Access::write);
  const auto jobs = db::jobs(connection, {});
  connection.write([&](SQLite::Database& sql) {
    for (std::size_t i = 0; i < jobs.size(); i += 2)
      db::finish(sql, jobs[i].id, test::ended(db::ExitReason::finished),
                 test::sample_result(0.2 + 0.001 * static_cast<double>(i % 700)),
                 std::vector<db::Remnant>{db::Remnant{.rank = 1, .particles = 150}});
  });
}

struct Row {
  int jobs;
  double submit_s, status_s, query_s, pause_s, overhead_ms, idle_percent;
};

/// Wall time per job beyond the impact itself: forty real jobs among all the others, one at a time.
double overhead_ms(const fs::path& folder) {
  constexpr int real = 40;
  test::eerie(folder, {"pause", "--all"});
  write_sweep(folder / "real.json", "real", real, 20);
  test::eerie(folder, {"submit", "real.json", "--priority", "9"});
  const double wall = seconds_of([&] {
    test::eerie(folder, {"daemon", "--until-idle", "--workers", "1", "--min-free-mb", "0"});
  });
  const db::Connection connection(folder / "eerie.sqlite", db::Access::read);
  double of_impacts = 0;
  for (const db::Job& job : db::jobs(connection, {.selection = {.sweep = "real"}}))
    if (const auto stored =
            job_folder::read_result(job_folder::job_folder(connection).of(job.hash), job.hash))
      of_impacts += stored->result.wall_s;
  return (wall - of_impacts) / real * 1000;
}

/// Processor time of an idle daemon, per cent of one core.
double idle_percent(const fs::path& folder) {
  constexpr double watched_s = 10;
  test::Program daemon(folder, {"daemon", "--workers", "1", "--min-free-mb", "0"});
  const auto ticks = [&] { return static_cast<double>(test::processor_ticks(daemon.pid())); };
  const auto wait = [](double s) {
    const auto start = Clock::now();
    test::eventually([&] { return Clock::now() - start > std::chrono::duration<double>(s); });
  };
  wait(3);
  const double before = ticks();
  wait(watched_s);
  return (ticks() - before) / watched_s;  // a tick is a hundredth of a second
}

Row measure(int jobs) {
  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path();
  const auto eerie = [&](std::vector<std::string> words) {
    const test::Ended ended = test::eerie(folder, words);
    if (ended.code != 0) throw std::runtime_error(words.front() + ": " + ended.err);
  };
  Row row{};
  row.jobs = jobs;
  write_sweep(folder / "sweep.json", "large", jobs, 30000);
  row.submit_s = seconds_of([&] { eerie({"submit", "sweep.json"}); });
  finish_half(folder / "eerie.sqlite");
  row.status_s = least_of(5, [&] { eerie({"status"}); });
  row.query_s = least_of(5, [&] {
    eerie({"query", "--v", "20:20.2", "--eer", "--format", "csv"});
  });
  row.pause_s = seconds_of([&] { eerie({"pause", "--all"}); });
  row.idle_percent = idle_percent(folder);
  row.overhead_ms = overhead_ms(folder);
  return row;
}

void draw(const fs::path& csv, const fs::path& picture) {
  drawing::Script script = drawing::gnuplot_terminal(picture, 255, 270);
  script += bench::data_block("$rows", csv);
  script += drawing::Literal(R"(
set logscale xy
set xtics ('1,000' 1e3, '10,000' 1e4, '100,000' 1e5)
set xlabel 'jobs in the database' offset 0,0.5
set xrange [700:150000]
set border lw 0.5
set tics scale 0.5
set title 'Time of each command; in brackets: at most (s)' font ',7'
set key outside top left horizontal Left reverse samplen 1 maxcols 2 font ',6.5'
set grid ytics lc rgb '#dddddd'
set ylabel 'time (s); overhead: s per job' offset 1
plot $rows using 1:2 with linespoints pt 7 lc rgb '#0072b2' title 'submit (10)', \
     $rows using 1:3 with linespoints pt 5 lc rgb '#d55e00' title 'status (0.2)', \
     $rows using 1:4 with linespoints pt 9 lc rgb '#009e73' title 'query (0.2)', \
     $rows using 1:5 with linespoints pt 11 lc rgb '#cc79a7' title 'pause all', \
     $rows using 1:($6/1000) with linespoints pt 13 lc rgb '#e69f00' title 'overhead (0.05)'
)");
  drawing::run_gnuplot(script, picture);
}

}  // namespace
}  // namespace eerie

int main(int argc, char** argv) {
  using namespace eerie;
  if (argc < 2) {
    fmt::print(stderr, "usage: eerie_scale FOLDER [LARGEST]   (0: draw scale.csv again)\n");
    return 2;
  }
  const fs::path folder = argv[1];
  const int largest = argc > 2 ? std::stoi(argv[2]) : 100'000;
  fs::create_directories(folder);
  std::string csv = "jobs,submit_s,status_s,query_s,pause_all_s,overhead_per_job_ms,idle_percent\n";
  for (int jobs = 1000; jobs <= largest; jobs *= 10) {
    const Row r = measure(jobs);
    csv += fmt::format("{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.3g}\n", r.jobs, r.submit_s,
                       r.status_s, r.query_s, r.pause_s, r.overhead_ms, r.idle_percent);
    fmt::print("{}", csv.substr(csv.rfind('\n', csv.size() - 2) + 1));
    std::fflush(stdout);
  }
  if (largest > 0) install_text(folder / "scale.csv", csv);
  draw(fs::absolute(folder / "scale.csv"), folder / "scale.svg");
}
