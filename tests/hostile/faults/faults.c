/* Lets the n-th operation on files below a folder go wrong, in a process and in all that it starts.

   The child calls arm(): from then on the kernel stops it, and its children, before each operation of the list below.
   The parent calls watch(), which counts those that concern the folder. Linux on x86-64. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

enum { NONE, KILL, HALF, FULL, FULL_ONCE, BROKEN_ONCE };
enum { GROWS = 1, WRITES = 2 };

/* Where a call names its file: an open one, a path (after the folder that it starts from, if >= 0). */
static const struct call { int number; const char *name; int fd, at, path, kind; } CALLS[] = {
    {SYS_write, "write", 0, -1, -1, GROWS | WRITES},
    {SYS_pwrite64, "pwrite", 0, -1, -1, GROWS | WRITES},
    {SYS_writev, "writev", 0, -1, -1, GROWS},
    {SYS_pwritev, "pwritev", 0, -1, -1, GROWS},
    {SYS_sendfile, "sendfile", 0, -1, -1, GROWS},
    {SYS_copy_file_range, "copy_file_range", 2, -1, -1, GROWS},
    {SYS_fallocate, "fallocate", 0, -1, -1, GROWS},
    {SYS_ftruncate, "ftruncate", 0, -1, -1, GROWS},
    {SYS_fsync, "fsync", 0, -1, -1, GROWS},
    {SYS_fdatasync, "fdatasync", 0, -1, -1, GROWS},
    {SYS_openat, "open", -1, 0, 1, GROWS},
    {SYS_creat, "open", -1, -1, 0, GROWS},
    {SYS_truncate, "truncate", -1, -1, 0, GROWS},
    {SYS_mkdir, "mkdir", -1, -1, 0, GROWS},
    {SYS_mkdirat, "mkdir", -1, 0, 1, GROWS},
    {SYS_rename, "rename", -1, -1, 1, GROWS},
    {SYS_renameat, "rename", -1, 2, 3, GROWS},
    {SYS_renameat2, "rename", -1, 2, 3, GROWS},
    {SYS_link, "link", -1, -1, 1, GROWS},
    {SYS_linkat, "link", -1, 2, 3, GROWS},
    {SYS_symlink, "symlink", -1, -1, 1, GROWS},
    {SYS_symlinkat, "symlink", -1, 1, 2, GROWS},
    {SYS_unlink, "unlink", -1, -1, 0, 0},
    {SYS_unlinkat, "unlink", -1, 0, 1, 0},
    {SYS_rmdir, "rmdir", -1, -1, 0, 0},
};
enum { MANY = sizeof CALLS / sizeof *CALLS, MOST = 4096 };

static struct sock_filter filtered(int code, int value, int yes, int no) {
    return (struct sock_filter)BPF_JUMP(BPF_JMP | code | BPF_K, (unsigned)value, (unsigned char)yes, (unsigned char)no);
}

/* Ask the parent to watch, and the kernel to stop this process before each of the calls. */
int arm(void) {
    struct sock_filter filter[MANY + 8];
    const int writing = O_WRONLY | O_RDWR | O_CREAT, flags = offsetof(struct seccomp_data, args[2]);
    int n = 0;
    filter[n++] = (struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr));
    filter[n++] = filtered(BPF_JEQ, SYS_openat, MANY, 0);
    for (int i = 0; i < MANY; i++)
        filter[n++] = filtered(BPF_JEQ, CALLS[i].number == SYS_openat ? -1 : CALLS[i].number, MANY - i + 3, 0);
    filter[n++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    filter[n++] = (struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS, (unsigned)flags);
    filter[n++] = filtered(BPF_JSET, writing, 1, 0);
    filter[n++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    filter[n++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRACE);
    filter[1].jt = MANY + 1; /* to the look at the flags */
    struct sock_fprog program = {(unsigned short)n, filter};
    if (ptrace(PTRACE_TRACEME, 0, 0, 0) != 0 || raise(SIGSTOP) != 0) return errno;
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return errno;
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0 ? errno : 0;
}

static void linked(pid_t pid, const char *what, char *path) {
    char link[64];
    snprintf(link, sizeof link, "/proc/%d/%s", pid, what);
    ssize_t size = readlink(link, path, PATH_MAX - 1);
    path[size < 0 ? 0 : size] = 0;
}

static void path_of(pid_t pid, const struct call *call, const unsigned long long *arguments, char *path) {
    char text[PATH_MAX] = "", base[PATH_MAX], what[32];
    if (call->path < 0) {
        snprintf(what, sizeof what, "fd/%d", (int)arguments[call->fd]);
        linked(pid, what, path);
        return;
    }
    unsigned long long from = arguments[call->path];
    for (size_t got = 0; got < sizeof text - 1 && memchr(text, 0, got) == NULL;) { /* page by page: the next may be none */
        size_t size = 4096 - (from + got) % 4096;
        if (size > sizeof text - 1 - got) size = sizeof text - 1 - got;
        struct iovec here = {text + got, size}, there = {(void *)(from + got), size};
        if (process_vm_readv(pid, &here, 1, &there, 1, 0) <= 0) break;
        got += size;
    }
    if (text[0] == '/') {
        memcpy(path, text, sizeof text);
        return;
    }
    int at = call->at < 0 ? AT_FDCWD : (int)arguments[call->at];
    snprintf(what, sizeof what, at == AT_FDCWD ? "cwd" : "fd/%d", at);
    linked(pid, what, base);
    if (snprintf(path, PATH_MAX, "%s/%s", base, text) < 0) path[0] = 0;
}

static void rang(int signal) { (void)signal; }

struct seen { long count, hit; int code, hung; };

/* Let the armed child run; of its calls below the root the one of number `at` goes wrong. All are written to a log. */
int watch(pid_t first, const char *root, long at, int mode, int seconds, const char *log_name, struct seen *seen) {
    const long options = PTRACE_O_EXITKILL | PTRACE_O_TRACESECCOMP | PTRACE_O_TRACEFORK | PTRACE_O_TRACEVFORK |
                         PTRACE_O_TRACECLONE | PTRACE_O_TRACEEXEC | PTRACE_O_TRACESYSGOOD;
    static pid_t living[MOST];
    int alive = 1, status, dying = 0;
    *seen = (struct seen){0, 0, -1, 0};
    living[0] = first;
    if (waitpid(first, &status, __WALL) != first || !WIFSTOPPED(status)) return -1;
    if (ptrace(PTRACE_SETOPTIONS, first, 0, options) != 0) return errno;
    FILE *log = fopen(log_name, "w");
    struct sigaction ring = {.sa_handler = rang}, before;
    sigaction(SIGALRM, &ring, &before);
    setitimer(ITIMER_REAL, &(struct itimerval){{0, 0}, {seconds, 0}}, NULL);
    ptrace(PTRACE_CONT, first, 0, 0);
    while (alive > 0) {
        pid_t pid = waitpid(-1, &status, __WALL);
        if (pid < 0 && errno == EINTR) { /* the time is over */
            seen->hung = !dying;
            dying = 1;
            for (int i = 0; i < alive; i++) kill(living[i], SIGKILL);
            setitimer(ITIMER_REAL, &(struct itimerval){{0, 0}, {1, 0}}, NULL);
            continue;
        }
        if (pid < 0) break;
        if (WIFEXITED(status) || WIFSIGNALED(status)) {
            for (int i = 0; i < alive; i++)
                if (living[i] == pid) living[i--] = living[--alive];
            if (pid == first) seen->code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
            continue;
        }
        int known = 0;
        for (int i = 0; i < alive; i++) known |= living[i] == pid;
        if (!known && alive < MOST) living[alive++] = pid;
        int signal = WSTOPSIG(status), event = status >> 16;
        if (signal == SIGTRAP && event == PTRACE_EVENT_SECCOMP && !dying) {
            struct user_regs_struct regs;
            ptrace(PTRACE_GETREGS, pid, 0, &regs);
            const unsigned long long arguments[] = {regs.rdi, regs.rsi, regs.rdx, regs.r10};
            const struct call *call = CALLS;
            while (call < CALLS + MANY - 1 && (unsigned long long)call->number != regs.orig_rax) call++;
            char path[PATH_MAX];
            path_of(pid, call, arguments, path);
            if (strncmp(path, root, strlen(root)) == 0) {
                seen->count++;
                fprintf(log, "%s\t%d\t%s\n", call->name, call->kind, path + strlen(root));
                int now = seen->count == at, refused = 0;
                if (now && (mode == KILL || mode == HALF)) {
                    seen->hit = 1;
                    if (mode == HALF) { /* write half, and see it written */
                        regs.rdx /= 2;
                        ptrace(PTRACE_SETREGS, pid, 0, &regs);
                        ptrace(PTRACE_SYSCALL, pid, 0, 0);
                        waitpid(pid, &status, __WALL);
                    }
                    dying = 1;
                    for (int i = 0; i < alive; i++) kill(living[i], SIGKILL);
                    continue;
                }
                if (now && mode == FULL && (call->kind & WRITES) && regs.rdx > 1) { /* what fits is written */
                    seen->hit = 1;
                    regs.rdx /= 2;
                    ptrace(PTRACE_SETREGS, pid, 0, &regs);
                } else if (mode == FULL && seen->count >= at && (call->kind & GROWS))
                    refused = ENOSPC;
                else if (now && mode == FULL_ONCE && (call->kind & GROWS))
                    refused = ENOSPC;
                else if (now && mode == BROKEN_ONCE)
                    refused = EIO;
                if (refused) {
                    seen->hit = 1;
                    regs.orig_rax = (unsigned long long)-1;
                    regs.rax = (unsigned long long)-refused;
                    ptrace(PTRACE_SETREGS, pid, 0, &regs);
                }
            }
            ptrace(PTRACE_CONT, pid, 0, 0);
        } else
            ptrace(PTRACE_CONT, pid, 0, signal == SIGTRAP || signal == SIGSTOP || signal == (SIGTRAP | 0x80) ? 0 : signal);
    }
    setitimer(ITIMER_REAL, &(struct itimerval){{0, 0}, {0, 0}}, NULL);
    sigaction(SIGALRM, &before, NULL);
    fclose(log);
    return 0;
}
