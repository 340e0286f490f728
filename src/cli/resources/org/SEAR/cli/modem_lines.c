/* Preloaded before a program, gives terminals without modem lines, as pseudo-terminals are, some that it can set and read: DTR, RTS and the like.
   What is set leads nowhere; the other side's are there. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdarg.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

static int set = TIOCM_DTR | TIOCM_RTS;

int ioctl(int file, unsigned long request, ...)
{
    int (*next)(int, unsigned long, ...) = (int (*)(int, unsigned long, ...)) dlsym(RTLD_NEXT, "ioctl");
    int asks = request == TIOCMGET || request == TIOCMSET || request == TIOCMBIS || request == TIOCMBIC;
    va_list list;
    va_start(list, request);
    int *lines = va_arg(list, int *);
    va_end(list);
    int before = errno;
    int result = next(file, request, lines);
    if (result == 0 || !asks || (errno != ENOTTY && errno != EINVAL) || !isatty(file)) return result;
    errno = before;
    if (request == TIOCMGET) *lines = set | TIOCM_CTS | TIOCM_CAR | TIOCM_DSR;
    else if (request == TIOCMSET) set = *lines;
    else if (request == TIOCMBIS) set |= *lines;
    else set &= ~*lines;
    return 0;
}
