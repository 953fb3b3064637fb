// SPDX-License-Identifier: GPL-3.0-or-later
// Each function of oplus.h by a good call and by bad ones.
#include <oplus/oplus.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifndef _WIN32
#include <sys/resource.h>
#endif

static int wrong = 0, checked = 0;

static void check(int line, int holds, const char* what) {
  ++checked;
  if (holds) return;
  ++wrong;
  printf("oplus_test.c:%d: %s\n    the message is: %s\n", line, what, oplus_message());
}

// A line that is not empty.
static int is_line(const char* text) {
  return text[0] != '\0' && strchr(text, '\n') == NULL && strlen(text) < 500;
}

#define CHECK(condition) check(__LINE__, condition, #condition)
#define GOOD(call) check(__LINE__, (call) == OPLUS_OK, #call)
// The call fails, and the message is a line that has this in it.
#define BAD(call, said)                                              \
  check(__LINE__,                                                    \
        (call) == OPLUS_INVALID_INPUT && is_line(oplus_message()) && \
            strstr(oplus_message(), said) != NULL,                   \
        #call)

static oplus_set* read_set(const char* text) {
  oplus_set* set = NULL;
  GOOD(oplus_read_set(text, &set));
  return set;
}

// Whether a set is the one with this text; frees both.
static int is(oplus_set* set, const char* text) {
  oplus_set* expected = read_set(text);
  int equal = 0;
  GOOD(oplus_equal(set, expected, &equal));
  oplus_free(set);
  oplus_free(expected);
  return equal;
}

// The same of texts.
static int says(char* text, const char* expected) {
  const int equal = text != NULL && strcmp(text, expected) == 0;
  if (!equal) printf("    %s\n", text);
  oplus_free_text(text);
  return equal;
}

static int is_wkt(oplus_set* set, const char* expected) {
  char* text = NULL;
  GOOD(oplus_wkt(set, -1, &text));
  oplus_free(set);
  return says(text, expected);
}

static const char* const square = "POLYGON((0 0,4 0,4 4,0 4,0 0))";
static const char* const frame = "POLYGON((0 0,5 0,5 5,0 5,0 0),(1 1,1 4,4 4,4 1,1 1))";
static oplus_set *p, *q, *line;  // a square, a square of side 2, a line string

static void texts(void) {
  oplus_set* set = NULL;
  char* text = NULL;
  GOOD(oplus_read("{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[\"1/3\",0],[0,0.5],[0,0]]]}",
                  &set));
  GOOD(oplus_wkt(set, -1, &text));
  CHECK(says(text, "POLYGON ((0 0, 1/3 0, 0 0.5, 0 0))"));
  GOOD(oplus_wkt(set, 2, &text));
  CHECK(says(text, "POLYGON ((0 0, 0.33 0, 0 0.5, 0 0))"));
  GOOD(oplus_geojson(set, -1, &text));
  CHECK(
      says(text,
           "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [\"1/3\", 0], [0, 0.5], [0, 0]]]}"));
  GOOD(oplus_fractions(set, &text));
  CHECK(says(text, "0 0 1/3 0 0 1/2"));
  oplus_free(set);
  GOOD(oplus_read("M 0 0 h 4 v 4 h -4 z", &set));
  CHECK(is(set, square));

  text = NULL, set = NULL;
  BAD(oplus_read("POLYGON((0 0,4 0,4 4,0\n4,0 1))", &set), "text:2:");
  BAD(oplus_read("POLYGON((0 0,4 4,4 0,0 4,0 0))", &set), "outer chain");
  BAD(oplus_read("", &set), "text");
  BAD(oplus_read(NULL, &set), "text: it is NULL; expected a pointer");
  BAD(oplus_read(square, NULL), "NULL");
  BAD(oplus_read("LINESTRING(0 0,1 1)", &set), "text:1:1");
  BAD(oplus_read_set("LINESTRING(0 0,1 \xff)", &set), "text:1:");
  BAD(oplus_read_set(NULL, &set), "NULL");
  BAD(oplus_wkt(p, 5000, &text), "digits: 5000; expected 0 to 4096");
  BAD(oplus_wkt(NULL, 0, &text), "NULL");
  BAD(oplus_geojson(p, 1, NULL), "NULL");
  BAD(oplus_fractions(NULL, &text), "NULL");
  CHECK(text == NULL && set == NULL);
}

static void arrays(void) {
  const double doubles[] = {0, 0, 5, 0, 5, 5, 0, 5, 1, 1, 4, 1, 4, 4, 1, 4};
  const int64_t integers[] = {0, 0, 4, 0, 4, 4, 0, 4, 6, 0, 7, 0, 9, 9};
  const size_t lengths[] = {4, 4}, mixed[] = {4, 2, 1};
  const int kinds[] = {OPLUS_OUTER, OPLUS_LINE, OPLUS_POINT}, holes[] = {OPLUS_HOLE, 4};
  oplus_set* set = NULL;
  size_t chains = 0, vertices = 0;
  GOOD(oplus_from_doubles(doubles, lengths, NULL, 2, &set));
  GOOD(oplus_sizes(set, &chains, &vertices));
  CHECK(chains == 2 && vertices == 8);
  CHECK(is(set, frame));
  GOOD(oplus_from_doubles(NULL, NULL, NULL, 0, &set));
  CHECK(is(set, "POLYGON EMPTY"));
  GOOD(oplus_from_integers(integers, mixed, kinds, 3, &set));
  int kinds_of[3] = {-1, -1, -1};
  size_t lengths_of[3] = {0, 0, 0};
  double xy[14] = {0};
  GOOD(oplus_to_doubles(set, kinds_of, lengths_of, xy));
  GOOD(oplus_to_doubles(set, NULL, NULL, NULL));
  CHECK(memcmp(kinds_of, kinds, sizeof kinds) == 0 && memcmp(lengths_of, mixed, sizeof mixed) == 0);
  for (int i = 0; i < 14; ++i) CHECK(xy[i] == (double)integers[i]);
  CHECK(
      is(set, "GEOMETRYCOLLECTION(POLYGON((0 0,4 0,4 4,0 4,0 0)),LINESTRING(6 0,7 0),POINT(9 9))"));
  // An integer that is no double.
  const int64_t large[] = {0, 0, INT64_MAX, 0, 0, INT64_MIN};
  const size_t three = 3;
  char* text = NULL;
  GOOD(oplus_from_integers(large, &three, NULL, 1, &set));
  GOOD(oplus_fractions(set, &text));
  CHECK(says(text, "0 -9223372036854775808 9223372036854775807 0 0 0"));
  oplus_free(set);

  set = NULL;
  const double infinite[] = {0, 0, 1, 0, 0, 1e308 * 10};
  BAD(oplus_from_doubles(infinite, &three, NULL, 1, &set), "infinite");
  BAD(oplus_from_doubles(doubles, lengths, holes, 1, &set), "kinds: a hole is first");
  BAD(oplus_from_doubles(doubles, lengths, holes + 1, 1, &set), "kinds: it is 4; expected 0 to 3");
  BAD(oplus_from_doubles(doubles, NULL, NULL, 1, &set), "lengths: it is NULL");
  BAD(oplus_from_integers(NULL, lengths, NULL, 1, &set), "xy: it is NULL");
  BAD(oplus_from_integers(integers, mixed, kinds + 2, 1, &set), "lengths: a point has 4 vertices");
  BAD(oplus_sizes(p, NULL, &vertices), "chains: it is NULL");
  BAD(oplus_to_doubles(NULL, NULL, NULL, NULL), "set: it is NULL");
  CHECK(set == NULL);
}

static void operations(void) {
  oplus_set *set = NULL, *room = read_set(frame),
            *half = read_set("POLYGON((0 0,0.5 0,0 0.5,0 0))");
  GOOD(oplus_sum(p, q, OPLUS_CLOSED, &set));
  CHECK(is(set, "POLYGON((0 0,6 0,6 6,0 6,0 0))"));
  GOOD(oplus_sum(line, q, OPLUS_CLOSED, &set));
  CHECK(is(set, "POLYGON((0 0,6 0,6 2,0 2,0 0))"));
  oplus_set* three = read_set("POLYGON((0 0,3 0,3 3,0 3,0 0))");
  GOOD(oplus_nfp(room, three, &set));
  CHECK(is_wkt(set, "GEOMETRYCOLLECTION (POLYGON ((-3 -3, 5 -3, 5 5, -3 5, -3 -3)), POINT (1 1))"));
  GOOD(oplus_nfp(line, three, &set));
  CHECK(is(set, "POLYGON((-3 -3,4 -3,4 0,-3 0,-3 -3))"));
  GOOD(oplus_reflected(three, &set));
  oplus_free(three);
  three = set;
  GOOD(oplus_sum(room, three, OPLUS_OPEN, &set));
  CHECK(is_wkt(set, "GEOMETRYCOLLECTION (POLYGON ((-3 -3, 5 -3, 5 5, -3 5, -3 -3)), POINT (1 1))"));
  CHECK(is(three, "POLYGON((-3 -3,0 -3,0 0,-3 0,-3 -3))"));
  GOOD(oplus_ifp(p, q, &set));
  CHECK(is(set, "POLYGON((0 0,2 0,2 2,0 2,0 0))"));
  GOOD(oplus_ifp(q, q, &set));
  CHECK(is(set, "POINT(0 0)"));
  GOOD(oplus_erosion(q, q, &set));
  CHECK(is(set, "POLYGON EMPTY"));
  GOOD(oplus_opening(room, q, &set));
  CHECK(is(set, "POLYGON EMPTY"));
  GOOD(oplus_closing(half, q, &set));
  CHECK(is(set, "POLYGON((0 0,0.5 0,0 0.5,0 0))"));
  GOOD(oplus_complement(p, &set));
  GOOD(oplus_complement(set, &three));
  // It is unbounded.
  char* text = NULL;
  BAD(oplus_wkt(set, -1, &text), "unbounded");
  size_t chains = 0, vertices = 0, lengths[2] = {9, 9};
  GOOD(oplus_sizes(set, &chains, &vertices));
  GOOD(oplus_to_doubles(set, NULL, lengths, NULL));
  CHECK(chains == 2 && vertices == 4 && lengths[0] == 0 && lengths[1] == 4 && text == NULL);
  oplus_free(set);
  CHECK(is(three, square));
  GOOD(oplus_disc("1", OPLUS_CONTAIN, "1/2", &set));
  int inside = 0;
  GOOD(oplus_contains(set, 0.6, 0.8, &inside));
  CHECK(inside);
  oplus_free(set);
  GOOD(oplus_rounded(half, "1", OPLUS_CONTAIN, &set));
  CHECK(is(set, "POLYGON((0 0,1 0,1 1,0 1,0 0))"));

  set = NULL;
  BAD(oplus_sum(NULL, q, OPLUS_CLOSED, &set), "p: it is NULL");
  BAD(oplus_sum(p, q, 2, &set), "boundary: it is 2; expected 0 to 1");
  oplus_set* open = NULL;
  GOOD(oplus_nfp(room, q, &open));
  oplus_free(open);
  GOOD(oplus_nfp(q, q, &open));
  oplus_free(open);
  BAD(oplus_nfp(p, NULL, &set), "q: it is NULL");
  BAD(oplus_ifp(line, q, &set), "p: it has lines or points; expected a region");
  BAD(oplus_erosion(p, line, &set), "q: it has lines or points");
  BAD(oplus_opening(p, NULL, &set), "NULL");
  BAD(oplus_closing(p, q, NULL), "NULL");
  BAD(oplus_reflected(NULL, &set), "NULL");
  BAD(oplus_complement(NULL, &set), "NULL");
  BAD(oplus_disc("1", OPLUS_NEAREST, "1/2", &set), "side: it is 0");
  BAD(oplus_disc("-1", OPLUS_CONTAIN, "1/2", &set), "positive");
  BAD(oplus_disc("1", OPLUS_CONTAIN, "half", &set), "half");
  BAD(oplus_disc("1", OPLUS_CONTAIN, NULL, &set), "error: it is NULL");
  BAD(oplus_rounded(p, "0", OPLUS_NEAREST, &set), "positive");
  BAD(oplus_rounded(p, "1", 3, &set), "side: it is 3; expected 0 to 2");
  CHECK(set == NULL);
  oplus_free(room);
  oplus_free(half);
}

static void queries(void) {
  double area = 0;
  char* text = NULL;
  int found = -1;
  oplus_set* third = read_set("POLYGON((0 0,1 0,0 2/3,0 0))");
  GOOD(oplus_area(third, &area, &text));
  CHECK(area == 1.0 / 3);
  CHECK(says(text, "1/3"));
  GOOD(oplus_area(third, NULL, NULL));
  oplus_free(third);
  GOOD(oplus_contains(p, 4, 1, &found));
  CHECK(found == 1);
  GOOD(oplus_contains(p, 4.5, 1, &found));
  CHECK(found == 0);
  GOOD(oplus_locate(p, "4", "1/3", &found));
  CHECK(found == OPLUS_ON_BOUNDARY);
  GOOD(oplus_locate(p, "39999999999999999999/10000000000000000000", "1", &found));
  CHECK(found == OPLUS_INSIDE);
  GOOD(oplus_locate(p, "-1e-300", "1", &found));
  CHECK(found == OPLUS_OUTSIDE);
  GOOD(oplus_equal(p, q, &found));
  CHECK(found == 0);
  GOOD(oplus_verify(p, q, "POLYGON((0 0,6 0,6 6,0 6,0 0))", OPLUS_CLOSED, &found, &text));
  CHECK(found == 1);
  CHECK(says(text, ""));
  GOOD(oplus_verify(p, q, "POLYGON((0 0,6 0,6 6,0 6,0 0),(2 2,2 3,3 2,2 2))", OPLUS_CLOSED, &found,
                    &text));
  CHECK(found == 0 && strncmp(text, "additional hole: ", 17) == 0);
  CHECK(strstr(text, "\nwitness: (") != NULL);
  oplus_free_text(text);
  GOOD(oplus_verify(p, q, square, OPLUS_OPEN, &found, NULL));
  CHECK(found == 0);

  text = NULL, found = -1, area = -1;
  BAD(oplus_area(NULL, &area, &text), "NULL");
  BAD(oplus_contains(p, 1e308 * 10, 0, &found), "infinite");
  BAD(oplus_contains(p, 1, 0, NULL), "contains: it is NULL");
  BAD(oplus_locate(p, "1/0", "0", &found), "1/0");
  BAD(oplus_locate(p, "1", NULL, &found), "y: it is NULL");
  BAD(oplus_equal(p, NULL, &found), "b: it is NULL");
  BAD(oplus_verify(p, q, "POLYGON((", OPLUS_CLOSED, &found, &text), "text:1:");
  BAD(oplus_verify(p, line, square, OPLUS_CLOSED, &found, &text), "q: it has lines or points");
  BAD(oplus_verify(p, q, square, 7, &found, &text), "boundary: it is 7");
  CHECK(text == NULL && found == -1 && area == -1);
}

static void as_written(void) {
  char *chains = NULL, *notes = NULL, *fault = NULL;
  GOOD(oplus_as_written("MULTIPOLYGON(((0 0,1 0,2 0,0 1/3,0 0)),((5 5,5 6,6 5,5 5)))", &chains, &notes,
                        &fault));
  CHECK(says(chains, "0 0 0 1 0 2 0 0 1/3\n0 5 5 6 5 5 6\n"));
  CHECK(says(notes, "text: outer chain of component 2 was clockwise; turned\n"));
  CHECK(says(fault, ""));
  GOOD(oplus_as_written("GEOMETRYCOLLECTION(POINT(7 8),LINESTRING(0 0,1 0,1 1))", &chains, &notes, &fault));
  CHECK(says(chains, "2 0 0 1 0\n2 1 0 1 1\n3 7 8\n"));
  CHECK(says(notes, ""));
  CHECK(says(fault, ""));
  GOOD(oplus_as_written("POLYGON((0 0,2 2,2 0,0 2,0 0),(9 9,9 8,8 8,9 9))", &chains, &notes, &fault));
  CHECK(says(chains, "0 0 0 2 2 2 0 0 2\n1 9 9 9 8 8 8\n"));
  CHECK(says(notes, ""));
  CHECK(is_line(fault) && strstr(fault, "cross") != NULL);
  oplus_free_text(fault);
  chains = NULL;
  BAD(oplus_as_written("POLYGON((", &chains, &notes, &fault), "text:1:");
  BAD(oplus_as_written(NULL, &chains, &notes, &fault), "text: it is NULL");
  BAD(oplus_as_written(square, &chains, NULL, &fault), "notes: it is NULL");
  CHECK(chains == NULL);
}

static void convolution(void) {
  const char *corner = "POLYGON((0 0,2 0,0 2,0 0))", *bent = "POLYGON((0 0,4 0,1 1,0 4,0 0))";
  char* text = NULL;
  GOOD(oplus_cycles(corner, corner, &text));
  CHECK(says(text, "0 0 0 0 0 0 1 0 0 0 1 0 0 0 1 0 1 0 1 0 1 0 2 0 0 0 2 0 2 0 1 0 2 0 0 0\n"));
  GOOD(oplus_cycles(bent, "POLYGON((0 0,0 1,1 0,0 0))", &text));
  CHECK(strstr(text, " 0 2 1") != NULL);  // an edge added to the reflex vertex
  oplus_free_text(text);
  text = NULL;
  BAD(oplus_cycles("POLYGON((0 0,2 2,2 0,0 2,0 0))", corner, &text), "cross");
  BAD(oplus_cycles(corner, NULL, &text), "q: it is NULL");

  int winding = -1, tangents = -1, is_on = -1;
  GOOD(oplus_winding(p, q, "1/2", "1/3", &winding, &tangents, &is_on));
  CHECK(winding == 1 && tangents == 1 && is_on == 0);
  GOOD(oplus_winding(p, q, "6", "3", &winding, &tangents, &is_on));
  CHECK(winding == 0 && tangents == 0 && is_on == 1);
  winding = -1;
  BAD(oplus_winding(p, line, "1", "1", &winding, &tangents, &is_on), "q: it has lines or points");
  BAD(oplus_winding(p, q, "1", NULL, &winding, &tangents, &is_on), "y: it is NULL");
  BAD(oplus_winding(p, q, "1", "1", NULL, &tangents, &is_on), "winding: it is NULL");
  CHECK(winding == -1);

  GOOD(oplus_way_out(p, q, "3", "1", &text));
  CHECK(says(text, "1 0 1 4 1") || says(text, "1 0 1 4 3"));
  text = NULL;
  BAD(oplus_way_out(p, q, "x", "1", &text), "x");
  BAD(oplus_way_out(p, NULL, "3", "1", &text), "q: it is NULL");
  oplus_set* empty = read_set("POLYGON EMPTY");
  BAD(oplus_way_out(empty, q, "3", "1", &text), "");
  oplus_free(empty);

  GOOD(oplus_certify(p, q, "POLYGON((0 0,6 0,6 6,0 6,0 0))", OPLUS_CLOSED, &text));
  CHECK(strncmp(text, "oplus certificate ", 18) == 0);
  oplus_free_text(text);
  text = NULL;
  BAD(oplus_certify(p, q, square, OPLUS_CLOSED, &text), ":");
  BAD(oplus_certify(p, q, NULL, OPLUS_CLOSED, &text), "claimed: it is NULL");
  CHECK(text == NULL);
}

// Threads use the same sets, and each has a message of its own.
static void* on_a_thread(void* argument) {
  const char* name = argument;
  oplus_set* set = NULL;
  int equal = 0;
  for (int i = 0; i < 200; ++i) {
    oplus_set* sum = NULL;
    if (oplus_read(name, &set) == OPLUS_OK || strstr(oplus_message(), name) == NULL)
      return argument;
    if (oplus_sum(p, q, OPLUS_CLOSED, &sum) != OPLUS_OK ||
        oplus_equal(sum, p, &equal) != OPLUS_OK || equal)
      return argument;
    oplus_free(sum);
    if (strstr(oplus_message(), name) == NULL) return argument;
  }
  return NULL;
}

static void threads(void) {
  char* names[] = {"first", "second", "third"};
  pthread_t started[3];
  oplus_set* set = NULL;
  BAD(oplus_read("main", &set), "main");
  for (int i = 0; i < 3; ++i) CHECK(pthread_create(&started[i], NULL, on_a_thread, names[i]) == 0);
  for (int i = 0; i < 3; ++i) {
    void* failed = NULL;
    CHECK(pthread_join(started[i], &failed) == 0 && failed == NULL);
  }
  CHECK(strstr(oplus_message(), "main") != NULL);
}

// Where the memory ends, the call fails and the program goes on.
static void memory(void) {
  const size_t size = 256u << 20;
  char* text = malloc(size);
  memset(text, ' ', size);
  text[size - 1] = '\0';
#ifndef _WIN32  // where no limit can be set; qemu, by which tests for other processors run, keeps none
  const struct rlimit small = {300u << 20, RLIM_INFINITY};
  CHECK(setrlimit(RLIMIT_AS, &small) == 0);
  void* volatile more = malloc(size);
#ifdef __x86_64__
  CHECK(more == NULL);
#endif
  if (more == NULL) {
    oplus_set* set = NULL;
    CHECK(oplus_read(text, &set) == OPLUS_NO_MEMORY);
    CHECK(strcmp(oplus_message(), "out of memory") == 0 && set == NULL);
  } else {
    puts("there is no limit of memory here: what a call does at the limit was not tested");
  }
  free(more);
#endif
  free(text);
  CHECK(is(read_set(square), square));
}

int main(void) {
  CHECK(strcmp(oplus_message(), "") == 0);
  CHECK(strcmp(oplus_version(), OPLUS_VERSION) == 0);
  oplus_free(NULL);
  oplus_free_text(NULL);
  p = read_set(square);
  q = read_set("POLYGON((0 0,2 0,2 2,0 2,0 0))");
  line = read_set("LINESTRING(0 0,4 0)");
  texts();
  arrays();
  operations();
  queries();
  as_written();
  convolution();
  threads();
  memory();
  oplus_free(p);
  oplus_free(q);
  oplus_free(line);
  printf("%d checks, %d wrong\n", checked, wrong);
  return wrong != 0;
}
