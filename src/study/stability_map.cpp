#include "study/stability_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "base/failure.h"
#include "base/hash.h"
#include "base/split.h"
#include "host/versions.h"
#include "map_column_json.h"
#include "methods/registry.h"
#include "shard_files.h"

namespace taut {
namespace {

constexpr double shortest_step = 1e-5, longest_step = 0.1;  // s
constexpr double fewest_passes = 1.0, most_passes = 3000.0;

// One column of one method's map.
struct Case {
  std::size_t column;  // in the grid
  const MapMethod* method;
  std::string key;
};

std::vector<Case> all_cases(const StabilityRequest& request) {
  std::vector<Case> cases;
  for (std::size_t column = 0; column < request.grid.columns.size(); ++column)
    for (const MapMethod& method : request.methods)
      cases.push_back({column, &method, fmt::format("{} {}", method.label, request.grid.columns[column])});
  return cases;
}

// A hash of all that decides what columns look like but for how it is worked out; which methods are asked for
// does not.
std::string asked_of(const Scene& scene, const MapGrid& grid) {
  Hash hash;
  hash.add(resolved_toml(scene)).add(grid.axes->name);
  hash.add(std::span<const double>(grid.columns)).add(std::span<const double>(grid.rows));
  return hash.add(std::span(&grid.duration, 1)).hex();
}

// The same, and what works it out.
std::string inputs_of(const Scene& scene, const MapGrid& grid) {
  return fmt::format("{} {}", asked_of(scene, grid),
                     Hash().add(physics_version()).add(judging_version()).hex());
}

// What is given, then the scene's own parameters where it is made for the method; defaults elsewhere.
Settings given_settings(const Scene& scene, const MapMethod& method) {
  Settings settings = method.settings;
  if (scene.settings.method == settings.method)
    settings.values.insert(scene.settings.values.begin(), scene.settings.values.end());
  return settings;
}

std::filesystem::path cases_file(const std::filesystem::path& folder) {
  return folder / "cases.jsonl";
}

// Runs columns that are missing, several at a time. A column's truth is the same for all methods that know
// rigid links, and is found once for each column that a thread works on.
class Sweep {
 public:
  Sweep(const Scene& scene, const StabilityRequest& request, CaseStore& store, Progress& progress,
        const StopTest& stop)
      : scene_(scene), request_(request), store_(store), progress_(progress), stop_(stop) {
    const std::vector<Case> cases = all_cases(request);
    std::map<std::size_t, std::vector<Case>> missing;
    std::size_t mine = 0;
    for (const Case& one : cases) {
      if (!request.shard.has(one.column)) continue;
      ++mine;
      if (store.has(one.key))
        ++done_;
      else
        missing[one.column].push_back(one);
    }
    for (auto& [column, methods] : missing) columns_.push_back(std::move(methods));
    progress_.start(static_cast<int>(mine));
    progress_.update(static_cast<int>(done_));
  }

  // False when stopped before the end.
  bool run() {
    const std::size_t count = std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()),
                                                    std::max<std::size_t>(1, columns_.size()));
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < count; ++i) threads.emplace_back([this] { work(); });
    }
    progress_.finish();
    if (failure_) std::rethrow_exception(failure_);
    return !stopping();
  }

 private:
  bool stopping() const { return (stop_ && stop_()) || failed_; }

  void work() {
    try {
      for (std::size_t next = next_++; next < columns_.size() && !stopping(); next = next_++)
        run_column(columns_[next]);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      failed_ = true;
    }
  }

  void run_column(const std::vector<Case>& cases) {
    std::map<bool, std::pair<Built, ColumnTruth>> by_rigidity;
    const double value = request_.grid.columns[cases.front().column];
    for (const Case& one : cases) {
      const Method& method = *find_method(one.method->settings.method);
      auto known = by_rigidity.find(method.can.rigid);
      if (known == by_rigidity.end()) {
        Built variant = map_variant(scene_.description, request_.grid.axes->columns, value, method);
        ColumnTruth truth = column_truth(variant, request_.grid.duration);
        known = by_rigidity.emplace(method.can.rigid, std::pair(std::move(variant), std::move(truth))).first;
      }
      const auto& [variant, truth] = known->second;
      const auto column = map_column(request_.grid, value, variant, truth,
                                     given_settings(scene_, *one.method), [this] { return stopping(); });
      if (!column) return;
      const std::lock_guard lock(mutex_);
      store_.add(one.key, map_column_to_json(*column));
      progress_.update(static_cast<int>(++done_));
    }
  }

  const Scene& scene_;
  const StabilityRequest& request_;
  CaseStore& store_;
  Progress& progress_;
  const StopTest& stop_;
  std::vector<std::vector<Case>> columns_;  // that miss something
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;  // guards what follows, and the store
  std::size_t done_ = 0;
  std::exception_ptr failure_;
};

using Results = std::map<std::string, std::string, std::less<>>;

// What a folder holds, of shards, too, whatever build it is of.
Results results_in(const std::filesystem::path& folder, const StabilityRequest& request, const Scene& scene) {
  const std::string asked = asked_of(scene, request.grid);
  Results results = read_cases(shard_file(cases_file(folder), request.shard), asked);
  if (request.shard.all())
    for (const std::filesystem::path& file : shard_files(cases_file(folder)))
      results.merge(read_cases(file, asked));
  return results;
}

StabilityMaps gather(const StabilityRequest& request, const Results& results) {
  StabilityMaps maps;
  maps.grid = request.grid;
  for (const MapMethod& method : request.methods) maps.maps.push_back({method.label, {}});
  for (const Case& one : all_cases(request)) {
    if (!request.shard.has(one.column)) continue;
    ++maps.count.planned;
    const auto result = results.find(one.key);
    if (result == results.end()) continue;
    ++maps.count.completed;
    const auto map = std::find_if(maps.maps.begin(), maps.maps.end(),
                                  [&](const MethodMap& each) { return each.method == one.method->label; });
    map->columns.push_back(map_column_from_json(result->second));
  }
  return maps;
}

}  // namespace

MapMethod parse_map_method(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, ':');
  MapMethod method{text, {std::string(parts.front()), {}}};
  if (complete_settings(method.settings).chooses_steps())
    throw BadRequest(fmt::format("method \"{}\" chooses its steps, and has no map over them", parts.front()));
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    const std::string name(parts[i].substr(0, equals));
    const std::string value(equals == std::string_view::npos ? "" : parts[i].substr(equals + 1));
    double number = 0.0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error == std::errc() && end == value.data() + value.size())
      method.settings.values[name] = number;
    else
      method.settings.values[name] = value;
  }
  complete_settings(method.settings);
  return method;
}

MapGrid make_map_grid(const Scene& scene, const MapAxes& axes, int columns, int rows, double longest) {
  MapGrid grid;
  grid.axes = &axes;
  grid.columns = spread_values(axes.least, axes.most, columns, axes.whole);
  grid.rows = axes.rows == MapRows::step ? spread_values(shortest_step, longest_step, rows, false)
                                         : spread_values(fewest_passes, most_passes, rows, true);
  grid.duration = std::min(scene.duration, longest);
  return grid;
}

void check_map_request(const Scene& scene, const StabilityRequest& request) {
  for (const MapMethod& method : request.methods)
    map_variant(scene.description, request.grid.axes->columns, request.grid.columns.front(),
                *find_method(method.settings.method));
}

StabilityMaps make_stability_maps(const Scene& scene, const StabilityRequest& request,
                                  const std::filesystem::path& folder, Progress& progress,
                                  const StopTest& stop) {
  check_map_request(scene, request);
  if (!request.run) return gather(request, results_in(folder, request, scene));
  const std::string inputs = inputs_of(scene, request.grid);
  CaseStore store(shard_file(cases_file(folder), request.shard), inputs, request.overwrite);
  if (request.shard.all()) take_over_shards(store, cases_file(folder), inputs, request.overwrite);
  const bool whole = Sweep(scene, request, store, progress, stop).run();
  if (whole) mark_end(store, request.shard);
  StabilityMaps maps = gather(request, store.results());
  maps.stopped = !whole;
  return maps;
}

}  // namespace taut
