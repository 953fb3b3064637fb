// SPDX-License-Identifier: GPL-3.0-or-later
/* The main program in C: runs OCaml's in a thread with a large stack, since Coq's functions recur as deep as lists are
   long. Where OCaml's runtime would end the program for want of memory, it says so in one line, with exit code 2. */
#include <caml/callback.h>
#include <caml/misc.h>
#include <caml/mlvalues.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static const char* name = "oplus";

static void memory_is_too_small(void) {
  const char* said[] = {name, ": the memory is too small for these files\n"};
  for (int i = 0; i < 2; ++i)
    if (write(STDERR_FILENO, said[i], strlen(said[i])) < 0) break;
  _exit(2);
}

static void end_of_runtime(char* message, va_list arguments) {
  (void)message, (void)arguments;
  memory_is_too_small();
}

/* The runtime's handler raises Stack_overflow in OCaml's code, and gives up in its own. */
static struct sigaction of_runtime;

static void overflow(int number, siginfo_t* where, void* context) {
  struct sigaction after;
  of_runtime.sa_sigaction(number, where, context);
  sigaction(SIGSEGV, NULL, &after);
  if (after.sa_handler == SIG_DFL) memory_is_too_small();
}

/* Called when the runtime has set its handler. */
value oplus_watch_stack(value unit) {
  struct sigaction mine;
  sigaction(SIGSEGV, NULL, &of_runtime);
  mine = of_runtime;
  mine.sa_sigaction = overflow;
  if (of_runtime.sa_flags & SA_SIGINFO) sigaction(SIGSEGV, &mine, NULL);
  return unit;
}

static void* run(void* arguments) {
  caml_main(arguments);
  return NULL;
}

int main(int count, char** arguments) {
  const char* slash = count > 0 ? strrchr(arguments[0], '/') : NULL;
  struct rlimit limit;
  pthread_attr_t attributes;
  pthread_t thread;
  size_t size = (size_t)1 << 34;
  if (count > 0) name = slash ? slash + 1 : arguments[0];
  caml_fatal_error_hook = end_of_runtime;
  /* A quarter of what there may be; if that is not to be had, less. */
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur / 4 < size) size = limit.rlim_cur / 4;
  pthread_attr_init(&attributes);
  for (size &= ~(size_t)0xffff; size >= (size_t)1 << 20; size = size / 2 & ~(size_t)0xffff)
    if (pthread_attr_setstacksize(&attributes, size) == 0 &&
        pthread_create(&thread, &attributes, run, arguments) == 0)
      return pthread_join(thread, NULL);
  memory_is_too_small();
}
