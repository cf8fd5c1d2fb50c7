/* SPDX-License-Identifier: BSD-3-Clause
 * Simulates a full disk and other faults of the system in a program that loads this library by LD_PRELOAD:
 *
 *   NETLOFT_DISK_BYTES=n   regular files may grow by n bytes in all; a write that needs more fails with ENOSPC
 *   NETLOFT_FAIL_WRITE=k   the k-th write (from 1) and all later ones fail with ENOSPC; 0 counts them only
 *   NETLOFT_FULL_KILLS=1   a write that would fail with ENOSPC kills the program instead, as a loss of power would
 *   NETLOFT_SIGNAL_AT=k    before the k-th deed (from 1) that changes a file, its name or what is on the disk, the
 *                          program gets the signal NETLOFT_SIGNAL, or SIGKILL
 *   NETLOFT_COUNT_FILE=f   at the end the numbers of writes and of deeds are written into f
 *   NETLOFT_SHORT_READS=1  every read of a regular file returns at most half of what was asked for
 *   NETLOFT_SHORT_WRITES=1 every write to a regular file takes at most half of what it is given
 *   NETLOFT_SLOW_WRITES=t  every write to a regular file takes t milliseconds of processor time
 *   NETLOFT_CLOCK_BACK=s   the clock of the system goes back by s seconds whenever it is read
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static atomic_long grown, writes, deeds;

static long limit(const char *name) {
  const char *text = getenv(name);
  return text ? atol(text) : -1;
}

static int is_file(int fd, struct stat *status) { return fstat(fd, status) == 0 && S_ISREG(status->st_mode); }

/* A deed is under way: a write, a sync, a truncation, a new name or the end of one. */
static void begin_deed(void) {
  const long at = limit("NETLOFT_SIGNAL_AT"), number = limit("NETLOFT_SIGNAL");
  if (atomic_fetch_add(&deeds, 1) + 1 == at) raise(number > 0 ? (int)number : SIGKILL);
}

static void take_time(void) {
  const long wait = limit("NETLOFT_SLOW_WRITES");
  for (const clock_t end = clock() + wait * (CLOCKS_PER_SEC / 1000); wait > 0 && clock() < end;) continue;
}

/* Whether the disk has room for `count` more bytes at `offset` of the file. */
static int has_room(int fd, size_t count, off_t offset) {
  struct stat status;
  if (!is_file(fd, &status)) return 1;
  begin_deed();
  take_time();
  const long fail_at = limit("NETLOFT_FAIL_WRITE"), bytes = limit("NETLOFT_DISK_BYTES");
  const long number = atomic_fetch_add(&writes, 1) + 1;
  if (fail_at > 0 && number >= fail_at) return 0;
  const off_t more = offset + (off_t)count - status.st_size;
  if (bytes < 0 || more <= 0) return 1;
  if (atomic_load(&grown) + more > bytes) return 0;
  atomic_fetch_add(&grown, more);
  return 1;
}

static int takes(int fd, size_t count, off_t offset) {
  if (has_room(fd, count, offset)) return 1;
  if (limit("NETLOFT_FULL_KILLS") == 1) raise(SIGKILL);
  return 0;
}

static size_t shortened(const char *name, int fd, size_t count) {
  struct stat status;
  return limit(name) == 1 && count > 1 && is_file(fd, &status) ? count / 2 : count;
}

static off_t place_of(int fd) {
  const off_t at = lseek(fd, 0, SEEK_CUR);
  return at < 0 ? 0 : at;
}

ssize_t write(int fd, const void *data, size_t count) {
  static ssize_t (*real)(int, const void *, size_t);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "write");
  count = shortened("NETLOFT_SHORT_WRITES", fd, count);
  if (takes(fd, count, place_of(fd))) return real(fd, data, count);
  errno = ENOSPC;
  return -1;
}

static ssize_t write_at(int fd, const void *data, size_t count, off_t offset) {
  static ssize_t (*real)(int, const void *, size_t, off_t);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "pwrite64");
  count = shortened("NETLOFT_SHORT_WRITES", fd, count);
  if (takes(fd, count, offset)) return real(fd, data, count, offset);
  errno = ENOSPC;
  return -1;
}

ssize_t pwrite(int fd, const void *data, size_t count, off_t offset) { return write_at(fd, data, count, offset); }
ssize_t pwrite64(int fd, const void *data, size_t count, off_t offset) { return write_at(fd, data, count, offset); }

ssize_t read(int fd, void *data, size_t count) {
  static ssize_t (*real)(int, void *, size_t);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "read");
  return real(fd, data, shortened("NETLOFT_SHORT_READS", fd, count));
}

static ssize_t read_at(int fd, void *data, size_t count, off_t offset) {
  static ssize_t (*real)(int, void *, size_t, off_t);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "pread64");
  return real(fd, data, shortened("NETLOFT_SHORT_READS", fd, count), offset);
}

ssize_t pread(int fd, void *data, size_t count, off_t offset) { return read_at(fd, data, count, offset); }
ssize_t pread64(int fd, void *data, size_t count, off_t offset) { return read_at(fd, data, count, offset); }

#define DEED(name, parameters, arguments)                  \
  int name parameters {                                   \
    static int(*real) parameters;                         \
    if (!real) *(void **)&real = dlsym(RTLD_NEXT, #name); \
    begin_deed();                                         \
    return real arguments;                                \
  }

DEED(fsync, (int fd), (fd))
DEED(fdatasync, (int fd), (fd))
DEED(ftruncate, (int fd, off_t length), (fd, length))
DEED(ftruncate64, (int fd, off_t length), (fd, length))
DEED(rename, (const char *from, const char *to), (from, to))
DEED(link, (const char *from, const char *to), (from, to))
DEED(unlink, (const char *path), (path))
DEED(mkdir, (const char *path, mode_t mode), (path, mode))

/* A file that is opened to be made is a deed as well. */
#define OPEN(name)                                            \
  int name(const char *path, int flags, ...) {                \
    static int (*real)(const char *, int, ...);               \
    if (!real) *(void **)&real = dlsym(RTLD_NEXT, #name);     \
    va_list more;                                             \
    va_start(more, flags);                                    \
    const mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0; \
    va_end(more);                                             \
    if (flags & O_CREAT) begin_deed();                        \
    return real(path, flags, mode);                           \
  }

OPEN(open)
OPEN(open64)

static long seconds_back(void) {
  static atomic_long readings;
  const long step = limit("NETLOFT_CLOCK_BACK");
  return step > 0 ? step * (atomic_fetch_add(&readings, 1) + 1) : 0;
}

int clock_gettime(clockid_t clock, struct timespec *now) {
  static int (*real)(clockid_t, struct timespec *);
  if (!real) *(void **)&real = dlsym(RTLD_NEXT, "clock_gettime");
  const int status = real(clock, now);
  if (status == 0 && clock == CLOCK_REALTIME) now->tv_sec -= seconds_back();
  return status;
}

time_t time(time_t *place) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (place) *place = now.tv_sec;
  return now.tv_sec;
}

int gettimeofday(struct timeval *restrict place, void *restrict zone) {
  struct timespec now;
  (void)zone;
  clock_gettime(CLOCK_REALTIME, &now);
  place->tv_sec = now.tv_sec, place->tv_usec = now.tv_nsec / 1000;
  return 0;
}

__attribute__((destructor)) static void report(void) {
  const char *file = getenv("NETLOFT_COUNT_FILE");
  FILE *out = file ? fopen(file, "w") : NULL;
  if (!out) return;
  fprintf(out, "%ld %ld\n", atomic_load(&writes), atomic_load(&deeds));
  fclose(out);
}
