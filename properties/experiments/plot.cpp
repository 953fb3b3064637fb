// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/plot.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace oplus {

namespace {

std::string in_quotes(const std::string& text) { return '"' + text + '"'; }

/// Which rows a series shows is gnuplot's to decide; whether any has both numbers is known here.
bool has_points(const Table& table, const std::string& x, const std::string& y) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [&](const Row& row) { return number(row, x) && number(row, y); });
}

std::string drawn_series(const Series& series, const std::string& csv, const Axes& axes) {
  std::string y = "column(" + in_quotes(series.column) + ")";
  if (axes.y_factor != 1) y = shown(axes.y_factor) + " * " + y;
  if (!series.only_where.empty()) y = "(" + series.only_where + ") ? " + y + " : NaN";
  const std::string points =
      in_quotes(csv) + " using (column(" + in_quotes(axes.x_column) + ")):(" + y + ")";
  const std::string colour = " linecolor rgb " + in_quotes(series.colour);
  const std::string title = " title " + in_quotes(series.title);
  if (!series.fit)
    return points + " smooth unique with linespoints pointtype 7 pointsize 0.5" + colour + title;
  return points + " with points pointtype 7 pointsize 0.5" + colour + title + ", \\\n     " +
         formula(*series.fit) + " with lines" + colour + " notitle";
}

}  // namespace

std::optional<Plot> plot_of(const std::string& name, const std::string& csv, const Table& table,
                            const Axes& axes, const std::vector<Series>& series) {
  std::string drawn;
  for (const Series& one : series) {
    if (!has_points(table, axes.x_column, one.column)) continue;
    drawn += (drawn.empty() ? "plot " : ", \\\n     ") + drawn_series(one, csv, axes);
  }
  if (drawn.empty()) return std::nullopt;
  return Plot{name,
              "set title " + in_quotes(axes.title) + "\nset xlabel " + in_quotes(axes.x_label) +
                  "\nset ylabel " + in_quotes(axes.y_label) + '\n' +
                  (axes.logarithmic ? "set logscale xy\n" : "set xrange [0:]\nset yrange [0:]\n") +
                  drawn + '\n'};
}

void add(std::vector<Plot>& plots, std::optional<Plot> plot) {
  if (plot) plots.push_back(std::move(*plot));
}

std::string to_gnuplot(const Plot& plot) {
  return "# Written by oplus-check experiments; gnuplot " + plot.name + ".gp writes " + plot.name +
         ".svg.\n"
         "set terminal svg size 720,432 dynamic background \"white\" font \"sans-serif,13\"\n"
         "set output \"" +
         plot.name +
         ".svg\"\n"
         "set datafile separator comma\n"
         "set datafile columnheaders\n"
         "set datafile missing NaN\n"  // else rows of other series would cut the lines
         "set key above\n"
         "set grid\n" +
         plot.script;
}

Drawn draw(const std::filesystem::path& folder, const Plot& plot) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::string program = "gnuplot";
  std::string script = plot.name + ".gp";
  char* const arguments[] = {program.data(), script.data(), nullptr};
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, program.c_str(), &actions, nullptr, arguments, environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return error == ENOENT ? Drawn::no_gnuplot : Drawn::failed;
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return Drawn::failed;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Drawn::drawn : Drawn::failed;
}

}  // namespace oplus
