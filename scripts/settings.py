"""What programs under test find in their environment, unless it is set."""
import os

SETTINGS = {
	"OMP_WAIT_POLICY": "passive",  # two tests at once: threads that wait leave the cores to others
	"GALLIVM_PERF": "nopt",  # llvmpipe compiles in half the time; `make matrix` runs what it optimizes
	# intercept_tls_get_addr: LeakSanitizer takes a library's thread-local block for what it is not,
	# and crashes at the end.
	"ASAN_OPTIONS": "detect_leaks=1:strict_string_checks=1:check_initialization_order=1:allocator_may_return_null=1:"
	                "intercept_tls_get_addr=0",
	"LSAN_OPTIONS": "suppressions=scripts/lsan.supp:print_suppressions=0",
	"UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1",
	"TSAN_OPTIONS": "ignore_noninstrumented_modules=1:halt_on_error=1:allocator_may_return_null=1:die_after_fork=0:"
	                f'suppressions="{os.path.abspath("scripts/tsan.supp")}"',
}
