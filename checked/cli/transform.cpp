// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/operations/image.hpp"
#include "checked/oplus/oplus.hpp"
#include "reference/arithmetic/rational_rotation.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/power_of_ten.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// An option as it was given.
struct Step {
  std::string option;
  std::string value;
};

/// A set, and where its image is written.
struct ReflectOptions {
  std::string file;
  Overlaps overlaps = Overlaps::refused;
  RegionOutput output;
  Boundary boundary = Boundary::closed;  ///< of the set, for rounding
};

struct TransformOptions : ReflectOptions {
  std::vector<Step> steps;  ///< in the order of the command line
  std::string angle_error = default_angle_error;
};

bool is_pair(const std::string& text) { return text.find(',') != std::string::npos; }

/// One step, and what is to be said of it.
struct Map {
  AffineMap map;
  std::string note = "";
};

Map with_angle(const AffineMap& rotation) {
  constexpr int digits = 12;
  const Rational degrees =
      angle_in_degrees({rotation.a, rotation.c}, Rational(1, power_of_ten(digits + 2)));
  return {rotation, "rotated exactly by the angle with cosine " + to_string(rotation.a) +
                        " and sine " + to_string(rotation.c) + ", " + to_string(degrees, digits) +
                        " degrees"};
}

Map rotation_of(const Step& step, const Rational& error) {
  if (is_pair(step.value)) return with_angle(rotation_to(pair_of_numbers(step.option, step.value)));
  const Rational degrees = number(step.option, step.value);
  const AffineMap map = rotation(degrees, error);
  return Rational(degrees / 90).get_den() == 1 ? Map{map} : with_angle(map);
}

Point factors(const Step& step) {
  if (is_pair(step.value)) return pair_of_numbers(step.option, step.value);
  const Rational factor = number(step.option, step.value);
  return {factor, factor};
}

Map map_of(const Step& step, const Rational& error) {
  const auto& [option, value] = step;
  if (option == "--translate") return {translation(pair_of_numbers(option, value))};
  if (option == "--rotate") return rotation_of(step, error);
  if (option == "--reflect") return {scaling(value == "x" ? 1 : -1, value == "y" ? 1 : -1)};
  const Point by = factors(step);
  return {scaling(by.x, by.y)};
}

ExitCode transform(const TransformOptions& options) {
  if (options.steps.empty())
    throw UsageError("nothing to do: give --translate, --scale, --rotate or --reflect");
  const Rational error = angle_error(options.angle_error);
  AffineMap map;
  std::vector<std::string> notes;
  for (const Step& step : options.steps) {
    const Map next = map_of(step, error);
    map = next.map * map;
    if (!next.note.empty()) notes.push_back(next.note);
  }
  require_writable({options.output.path});
  const Format format = output_format(options.output);
  write_set(options.output, format,
            image(map, set_in(read_summand_set(options.file, nullptr, options.overlaps))),
            options.boundary);
  for (const std::string& note : notes) say_note(note);
  return ExitCode::done;
}

ExitCode reflect(const ReflectOptions& options) {
  require_writable({options.output.path});
  const Format format = output_format(options.output);
  ReadSet read = read_summand_set(options.file, nullptr, options.overlaps);
  // What is closed by itself: of an open set, rounding may leave edges and points.
  if (is_region(read) && options.boundary == Boundary::closed) {
    write_region(options.output, format, reflected(std::move(read.region)));
    return ExitCode::done;
  }
  write_set(options.output, format, image(scaled_by(-1), set_in(read)), options.boundary);
  return ExitCode::done;
}

void add_image_options(const Command& command, ReflectOptions& options, const std::string& what) {
  add_output(command, options.output, what);
  add_union(command, options.overlaps, "R");
  add_open(
      command, options.boundary,
      "R is an open set, as sum --open and nfp write them: with --grid or --digits, line strings "
      "and points are rounded as parts of its complement, not of R");
}

}  // namespace

void add_transform(Program& program) {
  const auto& [command, options] =
      program.add("transform", "Move, scale, rotate or reflect a region, exactly", transform);
  command
      .file("R", options.file,
            "a region, which may be unbounded, a sum, line strings or points (docs/files.md); - is "
            "standard input")
      .required();
  // Options take effect in the order of the command line, which is when they are parsed.
  const auto add_step = [&command, &options](const std::string& name, const std::string& value,
                                             const std::string& what) {
    const auto take = [=, &options](const std::string& text) {
      options.steps.push_back({name, text});
    };
    return command.option_taken_by(name + " " + value, take, what).at_once();
  };
  add_step("--translate", "X,Y", "add X to each x and Y to each y");
  add_step("--scale", "F|FX,FY", "multiply by F, or each x by FX and each y by FY; not by zero");
  const Option rotate = add_step(
      "--rotate", "ANGLE|COS,SIN",
      "rotate about the origin, counterclockwise: by ANGLE degrees, a multiple of 90 exactly, any "
      "other nearly (see --angle-error), or exactly by the angle with this cosine and sine");
  add_step("--reflect", "NAME", "reflect in the x-axis, in the y-axis or in the origin")
      .one_of({"x", "y", "origin"});
  add_angle_error(command, options.angle_error).needs(rotate);
  add_image_options(command, options, "the result");
  command.footer(
      "The options apply in the order in which they are given, any of them several times. Without\n"
      "--grid and --digits no coordinate is rounded: sine and cosine are fractions.\n"
      "\n"
      "Example:\n"
      "  oplus gen star --n 8 --summand P -o part.wkt\n"
      "  oplus transform part.wkt --rotate 30 --translate 100,-2.5 -o placed.wkt\n"
      "  oplus transform part.wkt --rotate 3/5,4/5 --reflect x -o turned.wkt");
}

void add_reflect(Program& program) {
  const auto& [command, options] = program.add(
      "reflect", "Write -R, each point p of a region or another set R taken to -p", reflect);
  command
      .file(
          "R", options.file,
          "a region or a sum (docs/files.md), also line strings, points, and collections of all three; "
          "- is standard input")
      .required();
  add_image_options(command, options, "-R");
  command.footer(
      "R, moved by x, overlaps P if and only if x is inside the sum of P and -R, the no-fit polygon of\n"
      "P and R.\n"
      "\n"
      "Example:\n"
      "  oplus gen tight --n 6 --summand P -o part.wkt\n"
      "  oplus gen tight --n 6 --summand Q -o other.wkt\n"
      "  oplus reflect other.wkt | oplus sum part.wkt - --open -o no_fit.wkt");
}

}  // namespace oplus
