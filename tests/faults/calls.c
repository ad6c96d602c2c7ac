/* System calls, wherever they are made: a filter of the kernel's turns those of the kind into a signal, whose handler
 * either fails them or makes them itself, from the one place that the filter lets pass. What the command writes on
 * standard error does not count, so that a full disk does not hide its message; nor do interruptions of standard
 * output, after which the C library's streams give up. Nothing is given to the disk: it would take most of the time. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>
#include "tests/faults/fault.h"

#ifndef __x86_64__
#error "system calls are written for x86-64 only"
#endif

typedef struct {
	ts_fault_kind kind;
	int number;
} row;

static const row calls[] = {
	{TS_OPEN, SYS_open},       {TS_OPEN, SYS_openat},     {TS_OPEN, SYS_creat},      {TS_READ, SYS_read},
	{TS_READ, SYS_pread64},    {TS_READ, SYS_readv},      {TS_WRITE, SYS_write},     {TS_WRITE, SYS_pwrite64},
	{TS_WRITE, SYS_writev},    {TS_SHORT, SYS_write},     {TS_INTERRUPT, SYS_write}, {TS_FSYNC, SYS_fsync},
	{TS_FSYNC, SYS_fdatasync}, {TS_RENAME, SYS_rename},   {TS_RENAME, SYS_renameat}, {TS_RENAME, SYS_renameat2},
	{TS_UNLINK, SYS_unlink},   {TS_UNLINK, SYS_unlinkat}, {TS_UNLINK, SYS_rmdir},    {TS_MKDIR, SYS_mkdir},
	{TS_MKDIR, SYS_mkdirat},   {TS_LOCK, SYS_flock},      {TS_INTERRUPT, SYS_flock},
};
enum { N_CALLS = sizeof calls / sizeof calls[0] };

/* long pass(long number, long arguments[6]) */
long ts_calls_pass(long number, const long *arguments);
extern const char ts_calls_passed[];
__asm__(".text\n"
        ".hidden ts_calls_pass\n.globl ts_calls_pass\n.hidden ts_calls_passed\n.globl ts_calls_passed\n"
        "ts_calls_pass:\n"
        "mov %rdi, %rax\nmov %rsi, %r11\n"
        "mov (%r11), %rdi\nmov 8(%r11), %rsi\nmov 16(%r11), %rdx\n"
        "mov 24(%r11), %r10\nmov 32(%r11), %r8\nmov 40(%r11), %r9\n"
        "syscall\n"
        "ts_calls_passed: ret\n");

static ts_fault_kind watched;
static bool watching, moves;

/* Whether a call is one of the kind: to kill, those that change the disk. */
static bool counts(int number, const long *arguments)
{
	switch (number) {
	case SYS_write:
	case SYS_writev:
		return arguments[0] > STDERR_FILENO ||
		       (arguments[0] == STDOUT_FILENO && watched != TS_INTERRUPT && watched != TS_KILL);
	case SYS_open: return watched != TS_KILL || (arguments[1] & O_CREAT) != 0;
	case SYS_openat: return watched != TS_KILL || (arguments[2] & O_CREAT) != 0;
	default: return true;
	}
}

static long result_of(int number, long *arguments)
{
	bool syncs = number == SYS_fsync || number == SYS_fdatasync;
	if (moves && number == SYS_renameat2) return -EINVAL;
	if (syncs && watched != TS_FSYNC && watched != TS_INTERRUPT && watched != TS_KILL) return 0;
	if (!counts(number, arguments) || !ts_fault_is(watched)) return syncs ? 0 : ts_calls_pass(number, arguments);
	if (watched == TS_KILL) kill(getpid(), SIGKILL);
	if (watched != TS_SHORT) return -ts_fault_rows[watched].error;
	arguments[2] = (arguments[2] + 1) / 2;
	return ts_calls_pass(number, arguments);
}

static void on_call(int signal, siginfo_t *info, void *context)
{
	(void)signal;
	int error = errno;
	greg_t *r = ((ucontext_t *)context)->uc_mcontext.gregs;
	long arguments[6] = {r[REG_RDI], r[REG_RSI], r[REG_RDX], r[REG_R10], r[REG_R8], r[REG_R9]};
	r[REG_RAX] = result_of(info->si_syscall, arguments);
	errno = error;
}

/* The signal stays ours: LLVM takes it for a crash, and who holds back all signals would be killed by it. */
int sigaction(int number, const struct sigaction *set, struct sigaction *was)
{
	static __typeof__(&sigaction) next;
	if (next == NULL) next = (__typeof__(&sigaction))dlsym(RTLD_NEXT, "sigaction");
	return watching && number == SIGSYS ? 0 : next(number, set, was);
}

int pthread_sigmask(int how, const sigset_t *set, sigset_t *was)
{
	static __typeof__(&pthread_sigmask) next;
	if (next == NULL) next = (__typeof__(&pthread_sigmask))dlsym(RTLD_NEXT, "pthread_sigmask");
	sigset_t without;
	if (set != NULL) without = *set;
	if (set != NULL && how != SIG_UNBLOCK) sigdelset(&without, SIGSYS);
	return next(how, set != NULL ? &without : NULL, was);
}

int sigprocmask(int how, const sigset_t *set, sigset_t *was)
{
	int error = pthread_sigmask(how, set, was);
	if (error != 0) errno = error;
	return error == 0 ? 0 : -1;
}

static bool is_watched(ts_fault_kind kind)
{
	return kind == watched || kind == TS_FSYNC || (watched == TS_KILL && kind != TS_READ && kind != TS_LOCK);
}

void ts_calls_watch(ts_fault_kind kind)
{
	uint64_t passed = (uint64_t)(uintptr_t)ts_calls_passed;
	struct sock_filter rules[2 * N_CALLS + 7];
	unsigned short n = 0;
	watched = kind;
	moves = getenv("TOUCHSTONE_FAULT_MOVES") != NULL;
#define AT(member, more) offsetof(struct seccomp_data, member) + more
#define RULE(...) rules[n++] = (struct sock_filter)__VA_ARGS__
	RULE(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, AT(instruction_pointer, 0)));
	RULE(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)passed, 0, 3));
	RULE(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, AT(instruction_pointer, 4)));
	RULE(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)(passed >> 32), 0, 1));
	RULE(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
	RULE(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, AT(nr, 0)));
	for (int i = 0; i < N_CALLS; i++) {
		if (!is_watched(calls[i].kind)) continue;
		RULE(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)calls[i].number, 0, 1));
		RULE(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP));
	}
	RULE(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
#undef RULE
#undef AT
	struct sigaction action = {.sa_sigaction = on_call, .sa_flags = SA_SIGINFO | SA_NODEFER | SA_RESTART};
	struct sock_fprog program = {n, rules};
	if (sigaction(SIGSYS, &action, NULL) != 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
	    prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) {
		perror("fault: system calls cannot be watched");
		_exit(3);
	}
	watching = true;
}
