#include "chart_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <exception>
#include <stdexcept>
#include <utility>

#include "base/failure.h"
#include "base/json_text.h"
#include "errors_json.h"
#include "methods/registry.h"
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
  Json json{{"curve", chart.curves[done.point.curve].name},
            {"fineness", done.point.fineness},
            {"row", done.point.row}};
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

ChartCase read_case(const Json& json, const GridPoint& point) {
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

// The place of what has a name; throws where nothing has it.
template <typename Things>
std::size_t place_of(const Things& things, const std::string& name) {
  for (std::size_t i = 0; i < things.size(); ++i)
    if (things[i].name == name) return i;
  throw std::out_of_range(fmt::format("there is no \"{}\"", name));
}

ErrorKind kind_of(const std::string& name) {
  for (const ErrorKind kind : all_error_kinds)
    if (name_of(kind) == name) return kind;
  throw std::out_of_range(fmt::format("there is no error \"{}\"", name));
}

Chart read_chart(const Json& json) {
  Chart chart;
  json.at("scene").get_to(chart.scene);
  json.at("title").get_to(chart.title);
  json.at("masses").get_to(chart.masses);
  json.at("links").get_to(chart.links);
  json.at("size").get_to(chart.size);
  json.at("energy_scale").get_to(chart.energy_scale);
  chart.truth.times = {json.at("horizon").get<double>()};
  for (const Json& name : json.at("errors")) chart.errors.push_back(kind_of(name.get<std::string>()));
  chart.truth.smallest = errors_from_json(json.at("smallest_error_judged"));
  json.at("reference").get_to(chart.truth.how);
  json.at("remark").get_to(chart.truth.remark);
  json.at("omissions").get_to(chart.omissions);
  const Json& left_out = json.at("left_out");
  const auto run = json.at("completed").get<std::size_t>(), planned = json.at("planned").get<std::size_t>();
  chart.counts = {run, left_out.at("off_the_front").get<std::size_t>(),
                  left_out.at("no_gain").get<std::size_t>(), left_out.at("too_dear").get<std::size_t>(),
                  planned - run};
  json.at("budget").get_to(chart.budget);
  json.at("processor").get_to(chart.machine.processor);
  json.at("hardware_threads").get_to(chart.machine.threads);
  json.at("build").get_to(chart.machine.build);
  json.at("flags").get_to(chart.machine.flags);
  json.at("commit").get_to(chart.machine.commit);
  for (const Json& each : json.at("curves")) {
    MethodVariant curve;
    each.at("name").get_to(curve.name);
    each.at("method").get_to(curve.settings.method);
    curve.method = place_of(all_methods(), curve.settings.method);
    chart.curves.push_back(std::move(curve));
  }
  for (const Json& each : json.at("cases"))
    chart.cases.push_back(read_case(each, {place_of(chart.curves, each.at("curve").get<std::string>()),
                                           each.at("fineness").get<int>(), each.at("row").get<int>()}));
  return chart;
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
  return read_case(Json::parse(text), point);
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
  return json_text(json, 1) + "\n";
}

Chart chart_from_json(const std::string& text, const std::string& file) {
  try {
    return read_chart(Json::parse(text));
  } catch (const std::exception& error) {
    throw BadRequest(fmt::format("{} holds no chart of this program: {}", file, error.what()));
  }
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
