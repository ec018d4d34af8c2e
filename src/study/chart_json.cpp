#include "chart_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "errors_json.h"
#include "study/chart_files.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

Json settings_to_json(const Settings& settings) {
  Json json = Json::object();
  for (const auto& [name, value] : settings.values)
    std::visit([&, &key = name](const auto& plain) { json[key] = plain; }, value);
  return json;
}

// A case beside the curve it belongs to.
Json named_case(const Chart& chart, const ChartCase& done) {
  Json json{{"curve", chart.curves[done.point.curve].name}};
  json.update(case_to_json(done));
  if (!done.times.processor.empty()) json["seconds"] = done.seconds();
  return json;
}

// A field of a CSV table.
std::string field(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

// A setting that is a number; empty where the method has no such one.
std::string optional_value(const Settings& settings, std::string_view name) {
  return settings.values.contains(name) ? fmt::format("{}", settings.number(name)) : "";
}

std::string optional_number(const std::optional<double>& number) {
  return number ? fmt::format("{}", *number) : "";
}

}  // namespace

Json case_to_json(const ChartCase& done) {
  return {{"method", done.settings.method},
          {"settings", settings_to_json(done.settings)},
          {"diverged", done.run.diverged},
          {"trouble", done.run.trouble},
          {"errors", errors_to_json(done.run.errors)},
          {"steps", done.run.steps},
          {"link_solves", done.run.counts.link_solves},
          {"rounds", done.run.counts.rounds},
          {"factorisations", done.run.counts.factorisations},
          {"processor_seconds", done.times.processor},
          {"wall_seconds", done.times.wall}};
}

ChartCase case_from_json(const std::string& text, const GridPoint& point) {
  const Json json = Json::parse(text);
  ChartCase done;
  done.point = point;
  json.at("method").get_to(done.settings.method);
  for (const auto& [name, value] : json.at("settings").items()) {
    if (value.is_string())
      done.settings.values[name] = value.get<std::string>();
    else
      done.settings.values[name] = value.get<double>();
  }
  json.at("diverged").get_to(done.run.diverged);
  json.at("trouble").get_to(done.run.trouble);
  done.run.errors = errors_from_json(json.at("errors"));
  json.at("steps").get_to(done.run.steps);
  json.at("link_solves").get_to(done.run.counts.link_solves);
  json.at("rounds").get_to(done.run.counts.rounds);
  json.at("factorisations").get_to(done.run.counts.factorisations);
  json.at("processor_seconds").get_to(done.times.processor);
  json.at("wall_seconds").get_to(done.times.wall);
  return done;
}

std::string chart_json(const Chart& chart) {
  Json errors = Json::array(), curves = Json::array(), cases = Json::array();
  for (const ErrorKind kind : chart.errors) errors.push_back(name_of(kind));
  for (const MethodVariant& curve : chart.curves)
    curves.push_back({{"name", curve.name}, {"method", curve.settings.method}, {"colour", curve.method}});
  for (const ChartCase& done : chart.cases) cases.push_back(named_case(chart, done));
  const GridWalk::Counts& counts = chart.counts;
  const Json json{
      {"scene", chart.scene},
      {"title", chart.title},
      {"masses", chart.masses},
      {"links", chart.links},
      {"size", chart.size},
      {"energy_scale", chart.energy_scale},
      {"horizon", chart.truth.horizon()},
      {"errors", errors},
      {"smallest_error_judged", errors_to_json(chart.truth.smallest)},
      {"reference", chart.truth.how},
      {"remark", chart.truth.remark},
      {"omissions", chart.omissions},
      {"planned", counts.run + counts.open},
      {"completed", counts.run},
      {"left_out",
       {{"off_the_front", counts.off_front}, {"no_gain", counts.no_gain}, {"too_dear", counts.too_dear}}},
      {"budget", chart.budget},
      {"processor", chart.machine.processor},
      {"hardware_threads", chart.machine.threads},
      {"build", chart.machine.build},
      {"flags", chart.machine.flags},
      {"commit", chart.machine.commit},
      {"curves", curves},
      {"cases", cases}};
  return json.dump(1) + "\n";
}

std::string chart_csv(const Chart& chart) {
  std::string table = "scene,curve,method,steps_per_second,tolerance,passes,diverged";
  for (const ErrorKind kind : all_error_kinds) table += fmt::format(",{}_error", name_of(kind));
  table += ",link_solves,factorisations,processor_seconds,wall_seconds,runs,trouble\n";
  for (const ChartCase& done : chart.cases) {
    table +=
        fmt::format("{},{},{},{},{},{},{}", field(chart.scene), field(chart.curves[done.point.curve].name),
                    field(done.settings.method), optional_value(done.settings, "steps_per_second"),
                    optional_value(done.settings, "tolerance"), optional_value(done.settings, "passes"),
                    done.run.diverged ? 1 : 0);
    for (const ErrorKind kind : all_error_kinds) table += "," + optional_number(done.run.errors[kind]);
    table += fmt::format(",{},{},", done.run.counts.link_solves, done.run.counts.factorisations);
    if (!done.times.wall.empty())
      table += fmt::format("{},{}", done.seconds(), *std::ranges::min_element(done.times.wall));
    else
      table += ",";
    table += fmt::format(",{},{}\n", done.times.wall.size(), field(done.run.trouble));
  }
  return table;
}

}  // namespace taut
