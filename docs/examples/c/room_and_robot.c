// SPDX-License-Identifier: MIT
// How a robot's places are blocked, and what bad input is answered.
#include <oplus/oplus.h>
#include <stdio.h>
#include <stdlib.h>

static void check(oplus_code code) {
  if (code == OPLUS_OK) return;
  fprintf(stderr, "%s\n", oplus_message());
  exit(1);
}

int main(void) {
  const double corners[] = {0, 0, 1, 0, 1, 1, 0, 1};
  const size_t vertices = 4;
  oplus_set *room, *robot, *reflected, *blocked;
  check(oplus_read("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))", &room));
  check(oplus_from_doubles(corners, &vertices, NULL, 1, &robot));
  check(oplus_reflected(robot, &reflected));
  check(oplus_sum(room, reflected, OPLUS_CLOSED, &blocked));
  char *wkt, *area;
  check(oplus_wkt(blocked, -1, &wkt));
  check(oplus_area(blocked, NULL, &area));
  printf("%s\narea %s\n", wkt, area);
  oplus_free_text(wkt);
  oplus_free_text(area);
  oplus_free(blocked);
  oplus_free(reflected);
  oplus_free(robot);
  if (oplus_read("POLYGON((0 0,1 0,0 1))", &robot) != OPLUS_OK) puts(oplus_message());
  oplus_free(room);
  return 0;
}
