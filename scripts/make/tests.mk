# What tests are built of; and the targets that judge at length: sources, traces, compilers, distributions, the tests.

# Tests are one program by many names (tests/main.c), but for those that take arguments or define a function of libc or
# of the library. Linked into each: what tests begin with, and what lifts llvmpipe's limit of loops, which the driver
# finds by its name.
ALONE_C := $(patsubst %,tests/%.c,golden/file output/remove ports/candidate study/bench_start study/speed_limits)
TEST_ALSO_C := tests/begin.c tests/cli/preload/llvmpipe.c
LIFT := -Wl,--export-dynamic-symbol=LLVMBuildStore

# Most of them run for less time than -O3 takes to compile them.
$(BUILD)/obj/tests/%: OWN = -O1 -Dmain=test_$(subst /,_,$(patsubst $(BUILD)/obj/tests/%.c.o,%,$@))
$(call object,tests/main.c $(ALONE_C)): OWN := -O1 $(GENERATED)
TEST_LIST := $(BUILD)/gen/tests.inc
TEST_ROWS := $(foreach test,$(filter-out $(ALONE_C),\
	$(TEST_C)),TEST($(subst /,_,$(test:tests/%.c=%)), "$(test:tests/%.c=%)"))
$(TEST_LIST): FORCE
	$(call keep,$(TEST_ROWS))
$(call object,tests/main.c): $(TEST_LIST)

FIND_ABOVE := $(FIND_MODULE):'$$ORIGIN/..:$$ORIGIN/../..:$$ORIGIN/../../..:$$ORIGIN/../../../..'
link_test = $(call link,$(LIFT) $(FIND_ABOVE),-lcmocka $(call packages,--libs,OpenCL))
CLI_PARTS_O := $(filter-out %/main.c.o,$(CLI_O))
TEST_LINKS := $(call object,$(TEST_ALSO_C)) $(CLI_PARTS_O) $(BUILD)/libtouchstone.a
ALONE := $(ALONE_C:tests/%.c=$(BUILD)/tests/%)
$(ALONE): $(BUILD)/tests/%: $(BUILD)/obj/tests/%.c.o $(TEST_LINKS) | $(BUILD)/libtouchstone-image.so
	$(link_test)
$(BUILD)/tests/all: $(call object,tests/main.c $(filter-out $(ALONE_C),$(TEST_C))) $(TEST_LINKS) \
		| $(BUILD)/libtouchstone-image.so
	$(link_test)
	$(Q)mkdir -p $(sort $(dir $(TESTS)))
	$(Q)for test in $(filter-out $(ALONE),$(TESTS)); do ln -f $@ $$test || exit; done
$(filter-out $(ALONE),$(TESTS)): $(BUILD)/tests/all ;

# A driver of CUDA that needs no GPU, with an empty cache of kernels.
$(BUILD)/cuda/libcuda.so.1: $(wildcard tests/backends/cuda/*) src/backends/cuda/cu.h $(BUILD)/flags
	$(call say,LINK,$@)
	$(Q)rm -rf $(@D) && mkdir -p $(@D)/cache
	$(Q)$(CC) -std=c11 -O2 $(WARN) -fopenmp -fPIC -fvisibility=hidden -shared -Wl,-soname,$(@F) $(ROOTS) \
		-DTS_PTX='"tests/backends/cuda"' -DTS_CACHE='"$(abspath $(@D))/cache"' tests/backends/cuda/driver.c -ldl -o $@

# The command, noting who reads which parameter (src/model/param.h). What does not name the accessor is not built for
# it.
RECORD_C := $(filter $(LIB_C) $(CLI_C),$(shell grep -rl TS_PARAM src --include='*.c'))
RECORD_O := $(patsubst %,$(BUILD)/record/%.o,$(RECORD_C) tests/record/record.c)
$(BUILD)/record/%.c.o: %.c $(BUILD)/flags
	$(call compile,CC,-O1 -DTS_RECORD_PARAMS)
$(BUILD)/record/touchstone: $(RECORD_O) $(filter-out $(call object,$(RECORD_C)),$(CLI_O) $(LIB_O)) \
		| $(BUILD)/libtouchstone-image.so
	$(call link,$(FIND_MODULE):'$$ORIGIN/..')
-include $(patsubst %.o,%.d,$(RECORD_O) \
	$(call object,$(TEST_C) tests/main.c $(TEST_ALSO_C) $(wildcard tests/fuzz/*.c)))

##   fuzz               five minutes each of damaged files and command lines, by each program of tests/fuzz;
##                      FUZZ_S=seconds
FUZZ_S ?= 300
FUZZ := $(patsubst tests/fuzz/%.c,%,$(wildcard tests/fuzz/*.c))
FUZZ_BIN := $(FUZZ:%=build/fuzz/tests/fuzz/%)
# The limit of one allocation is above what the header of an EXR file makes OpenEXR ask for, before it looks for the
# bytes.
FUZZ_FLAGS = -max_total_time=$(FUZZ_S) -timeout=10 -rss_limit_mb=4096 -malloc_limit_mb=1048576 -print_final_stats=1 \
	-artifact_prefix=build/fuzz/
$(BUILD)/tests/fuzz/%: $(BUILD)/obj/tests/fuzz/%.c.o $(BUILD)/obj/tests/begin.c.o $(CLI_PARTS_O) \
		$(BUILD)/libtouchstone.a | $(BUILD)/libtouchstone-image.so
	$(call link,-fsanitize=fuzzer $(FIND_ABOVE))
fuzz: deps-test
	$(Q)$(MAKE) all
	$(Q)$(MAKE) config=fuzz $(FUZZ_BIN)
	$(Q)scripts/fuzz-seeds
	$(Q)mkdir -p $(FUZZ:%=build/fuzz/corpus/%)
	$(Q)for target in $(FUZZ); do \
		LSAN_OPTIONS=suppressions=scripts/lsan.supp build/fuzz/tests/fuzz/$$target $(FUZZ_FLAGS) -max_len=65536 \
			build/fuzz/corpus/$$target build/fuzz/seeds/$$target || exit 1; done

# For scripts that call make, which would ask this make for jobs, and be given one.
JOBS_OF_ITS_OWN := env -u MAKEFLAGS -u MAKELEVEL
short = $(if $(filter %-short,$@),--short)

##   matrix             compilers x optimisation x threads x denormals x architectures: one digest list
##   matrix-short       the part of it that .ci/run runs
matrix matrix-short:
	$(Q)scripts/install-deps --matrix
	$(Q)$(JOBS_OF_ITS_OWN) scripts/matrix $(short)

##   distros            chroots of Debian 12 and 13: builds, traces, packages, each gcc and clang that they carry
##   distros-short      the part of it that .ci/run runs
distros distros-short:
	$(Q)$(JOBS_OF_ITS_OWN) scripts/distros $(short)

##   mutants            defects planted in sources and traces: each must be found where it was planted
##   mutants-short      the part of it that .ci/run runs
mutants mutants-short: deps-test
	$(Q)$(MAKE) all
	$(Q)BUILD='$(BUILD)' COMPILE='$(CC) $(C_FLAGS) $(CPP_LIBS)' \
		LINK="$(CXX) $(LINK_FLAGS) -Wl,-rpath,'$(abspath $(BUILD))'" \
		WITH='$(CLI_O) $(BUILD)/libtouchstone.a $(LIBS)' scripts/mutants $(short) $(T)

##   mutants-src        mutants of src/, each run by the tests that reach it, and how many they kill;
##                      T="PARTS OF NAMES"; an hour
##   mutants-src-short  the part of it that .ci/run runs
mutants-src mutants-src-short:
	$(Q)scripts/install-deps --matrix
	$(Q)$(MAKE) all tests
	$(Q)BUILD='$(BUILD)' FLAGS='$(CPP_LIBS)' $(JOBS_OF_ITS_OWN) \
		scripts/mutants-src $(short) $(T)

##   faults             calls that fail, one by one, in small commands; T="COMMANDS OR KINDS"; most of an hour
##   faults-short       the part of it that .ci/run runs
faults faults-short: deps-test
	$(Q)$(MAKE) all
	$(Q)CC='$(CC)' BUILD='$(BUILD)' scripts/faults $(short) $(T)

##   release-check      what a release must pass beside .ci/run: all of tests with TS_WHOLE=1, faults, matrix, distros,
##                      mutants, mutants-src, fresh mutants, and the tests with each sanitizer; hours
release-check:
	$(Q)scripts/install-deps --matrix
	$(Q)for part in test test-devices test-long test-ports test-packages faults matrix distros mutants mutants-src; do \
		TS_WHOLE=1 $(MAKE) $$part || exit; done
	$(Q)$(MAKE) mutants-src T='--fresh commit'
	$(Q)for config in asan ubsan tsan; do $(MAKE) test config=$$config || exit; done

##   bench              the papers' tables, measured here, and every backend on one frame
bench: all
	for table in $$(build/touchstone list benches | awk 'NR > 1 && /^[a-z]/ { print $$1 }'); do \
		build/touchstone bench $$table || exit; done

.PHONY: fuzz matrix matrix-short distros distros-short mutants mutants-short mutants-src mutants-src-short faults \
	faults-short release-check bench
