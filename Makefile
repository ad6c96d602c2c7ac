# touchstone. `make help` lists the targets. scripts/make has what is generated before it is compiled, what tests are
# built of and what judges at length, and what is installed or packed.
MAKEFLAGS += -r --no-print-directory
.SUFFIXES:
.DELETE_ON_ERROR:
.SECONDARY:
.DEFAULT_GOAL := all

config ?= release
V ?= 0
ifeq ($(origin CC),default)
CC := gcc
endif
ifeq ($(origin CXX),default)
CXX := g++
endif
PKG_CONFIG ?= pkg-config
JOBS ?= $(shell nproc)
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(JOBS)
endif

# Configurations. OPT may be set: make OPT=-O0, make OPT="-O3 -march=native".
# With a sanitizer clang does not vectorize all that is asked for, and says so.
SANITIZE := -O1 -g1 -fno-omit-frame-pointer -Wno-pass-failed -fsanitize
OPT_release := -O3
OPT_debug := -Og -g
OPT_asan := $(SANITIZE)=address
OPT_ubsan := $(SANITIZE)=undefined -fno-sanitize-recover=all
OPT_tsan := $(SANITIZE)=thread
OPT_fuzz := $(SANITIZE)=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
OPT_coverage := -O0 -g --coverage
OPT ?= $(OPT_$(config))
ifeq (,$(OPT_$(config)))
$(error config=$(config): one of release debug asan ubsan tsan fuzz coverage)
endif
# libFuzzer is clang's; and gcc's libgomp is not instrumented: clang's libomp tells the sanitizer its barriers through
# Archer.
ifneq (,$(filter tsan fuzz,$(config)))
CC := clang
CXX := clang++
endif
BUILD ?= build/$(config)

# Warnings are errors with WERROR=1, as in .ci/run: another compiler warns of other things.
WERROR ?= 0
WARN := -Wall -Wextra -Wshadow $(if $(filter 1,$(WERROR)),-Werror)
# The numeric contract: these come after the user's flags.
EXACT := -ffp-contract=off -fno-math-errno -fno-trapping-math
# 1: gcc computes in double where C lets it, on s390x. 2: in the registers of x87.
EVALUATES := $(shell echo __FLT_EVAL_METHOD__ | $(CC) $(CPPFLAGS) $(CFLAGS) $(OPT) -std=c11 -E -P - 2>/dev/null)
ifeq ($(EVALUATES),1)
EXACT += -fexcess-precision=fast
else ifeq ($(EVALUATES),2)
$(error $(CC) computes floats in the registers of x87: OPT="$(OPT) -msse2 -mfpmath=sse" would be right)
endif
# gcc 12 stops with an internal error in its straight-line vectorizer when items.c is built for AVX-512.
ifneq (,$(findstring -march=,$(OPT)))
EXACT += -fno-tree-slp-vectorize
endif
# musl: one thread, for it has no OpenMP; libcrypto, whose SHA-256 calls nothing of its libc, is the system's.
ifneq (,$(findstring musl,$(CC)))
SYSTEM := $(shell $(CC) -print-multiarch)
THREADED := -Isrc/model/serial -idirafter /usr/include -idirafter /usr/include/$(SYSTEM) \
	-Wno-unknown-pragmas -Wno-unused-parameter -Wno-unused-variable
CORE_LIBS = /usr/lib/$(SYSTEM)/libcrypto.a -lm
REPORTS =
else
THREADED := -fopenmp
CORE_LIBS = $(if $(REPORTS),-ljansson) -lcrypto -lm
endif
# The folders of what touchstone-core reports beside text, by jansson; without by REPORTS=
REPORTS ?= cli/reports study/results output/json model/json
# Where includes begin: the public headers; src, and for tests/... the root, in quotes alone.
ROOTS := -Iinclude -iquote src -iquote .
COMMON = $(OPT) $(EXACT) -fPIC -fvisibility=hidden $(THREADED) $(WARN) $(ROOTS) -MMD -MP
C_FLAGS = $(CPPFLAGS) $(CFLAGS) -std=c11 -D_POSIX_C_SOURCE=200809L $(COMMON)
CXX_FLAGS = $(CPPFLAGS) $(CXXFLAGS) -std=c++17 $(COMMON)
LINK_FLAGS = $(LDFLAGS) $(OPT) $(filter -fopenmp,$(THREADED))
# The image module stands beside what is built; as RPATH, which also holds where a sanitizer opens it.
FIND_MODULE := -Wl,--disable-new-dtags,-rpath,'$$ORIGIN'

# Libraries. Embree and OpenCL are opened at run time. Embree brings no pkg-config file.
EMBREE := $(shell for v in 4 3; do \
		printf '\043include <embree%s/rtcore.h>\n' $$v | $(CC) -E -x c - >/dev/null 2>&1 && echo $$v && break; done)
packages = $(shell $(PKG_CONFIG) $(1) $(2) 2>/dev/null)
CPP_LIBS := -DTS_EMBREE=$(EMBREE) $(call packages,--cflags,OpenImageIO jansson libcrypto libpng tinygltf zlib libzstd)
LIBS := $(call packages,--libs,jansson libcrypto libpng zlib libzstd tinygltf) -ldl -lm
IMAGE_LIBS := $(call packages,--libs,OpenImageIO)
# These do without, or install it first.
WITHOUT := core %/touchstone-core golden demo test check test-% dist fuzz matrix% distros% mutants% faults% release% \
	style format deps-% uninstall clean help
ifeq (,$(EMBREE))
ifneq (,$(filter-out $(WITHOUT),$(or $(MAKECMDGOALS),all)))
$(error Embree 3 or 4 is not installed: run scripts/install-deps (or make demo))
endif
endif

# Sources, by folder. ITEM_HEADERS: those that have kernels, as points/splat: items.c is compiled for each.
ITEMS_C := src/backends/c/items.c
ITEM_HEADERS := $(patsubst src/kernels/%.h,%,\
	$(shell grep -lE '^TS_(FN|CALL) void ts_k_\w+_item.const|^TS_VECTORS.\w+.$$' src/kernels/*/*.h))
every = $(filter-out $(ITEMS_C),$(wildcard $(foreach in,* */* */*/* */*/*/*,$(1)/$(in).$(2))))
LIB_C := $(filter-out src/cli/%,$(call every,src,c))
IMAGE_CC := src/image/openimageio.cc
LIB_CC := $(filter-out $(IMAGE_CC),$(call every,src,cc))
CLI_C := $(filter-out src/cli/core/%,$(call every,src/cli,c))
CORE_C := $(filter-out $(ITEMS_C),$(wildcard $(patsubst %,src/%/*.c,model output backends backends/c backends/c/* \
	methods methods/* families golden vectors scene scene/builtin trace/emitted study/asked \
	cli/core cli/line cli/golden $(REPORTS))))
TEST_C := $(filter-out $(patsubst %,tests/%,$(shell sed '/^\#/d' tests/apart.txt)),$(call every,tests,c))

object = $(patsubst %,$(BUILD)/obj/%.o,$(1))
ITEMS_O := $(ITEM_HEADERS:%=$(BUILD)/obj/$(ITEMS_C:.c=)/%.o)
LIB_O := $(call object,$(LIB_C) $(LIB_CC)) $(ITEMS_O)
IMAGE_O := $(call object,$(IMAGE_CC) $(patsubst %,src/model/%.c,error memory))
CLI_O := $(call object,$(CLI_C))
CORE_O := $(call object,$(CORE_C)) $(ITEMS_O)
TESTS := $(TEST_C:tests/%.c=$(BUILD)/tests/%)

# What rules share. Lines of recipes: what is done is said, unless V=1 shows the commands.
ifeq ($(V),0)
Q := @
say = @echo "  $(1)	$(2)"
endif
# Writes the text to a file that does not have it yet: what depends on the file is made again when the text changes.
define keep
$(Q)mkdir -p $(@D)
$(Q)echo '$(1)' | cmp -s - $@ || echo '$(1)' > $@
endef
# OWN: flags of single objects. Not added to CPPFLAGS or OPT: what a user gives those on the command line cannot be
# added to.
define compile
$(call say,$(1),$<$(3))
$(Q)mkdir -p $(@D)
$(Q)$($(1)) $($(1:CC=C)_FLAGS) $(CPP_LIBS) $(2) $(OWN) -c $< -o $@
endef
# A program, with flags before its objects and behind the libraries.
define link
$(call say,LINK,$@)
$(Q)mkdir -p $(@D)
$(Q)$(CXX) $(LINK_FLAGS) $(1) $(filter %.o %.a,$^) $(LIBS) $(2) -o $@
endef

include $(patsubst %,scripts/make/%.mk,generated tests install)

##   all (default)      libraries and the command: build/touchstone; with DEVICES= without the kernels of Vulkan, CUDA
##                      and `explain`
all: $(BUILD)/libtouchstone.a $(BUILD)/libtouchstone.so $(BUILD)/touchstone
	$(Q)ln -sfn $(patsubst build/%,%,$(BUILD))/touchstone build/touchstone
	$(say_left_out)

$(BUILD)/libtouchstone.a: $(LIB_O)
	$(call say,AR,$@)
	$(Q)rm -f $@ && $(AR) rcs $@ $^

# The map hides what C++ headers of other libraries make visible, and of the module all but its table.
$(BUILD)/libtouchstone.map $(BUILD)/libtouchstone-image.map: | $(BUILD)/flags
	$(Q)echo '{ global: $(if $(findstring image,$@),ts_image_codec_module,ts_*); local: *; };' > $@
shared = $(CXX) $(LINK_FLAGS) -shared -Wl,-soname,$(1) -Wl,--version-script=$(filter %.map,$^) $(filter %.o,$^)
$(BUILD)/libtouchstone.so: $(LIB_O) $(BUILD)/libtouchstone.map | $(BUILD)/libtouchstone-image.so
	$(call say,LINK,$@)
	$(Q)$(call shared,$(@F).$(ABI)) $(FIND_MODULE):'$$ORIGIN/touchstone' $(LIBS) -o $@
$(BUILD)/libtouchstone-image.so: $(IMAGE_O) $(BUILD)/libtouchstone-image.map
	$(call say,LINK,$@)
	$(Q)$(call shared,$(@F)) $(IMAGE_LIBS) -o $@

$(BUILD)/touchstone: $(CLI_O) $(BUILD)/libtouchstone.a | $(BUILD)/libtouchstone-image.so
	$(call link,$(FIND_MODULE))

##   core               static command for digests and goldens: build/core/touchstone-core
CORE_BUILD ?= $(if $(filter command%,$(origin BUILD)),$(BUILD),build/core)
# Neither clang's OpenMP runtime nor the sanitizers have static libraries.
CORE_STATIC = $(if $(findstring clang,$(CC))$(findstring -fsanitize,$(OPT)),,-static)
core:
	$(Q)$(MAKE) BUILD=$(CORE_BUILD) $(CORE_BUILD)/touchstone-core
$(call object,src/cli/core/main.c): OWN := $(if $(REPORTS),-DTS_REPORTS)
# The linker warns that libcrypto's name look-up needs shared libraries. Nothing here looks names up: show errors only.
$(BUILD)/touchstone-core: $(CORE_O)
	$(call say,LINK,$@)
	$(Q)said=$$($(CC) $(LINK_FLAGS) $(CORE_STATIC) $^ $(CORE_LIBS) -o $@ 2>&1) || { echo "$$said"; exit 1; }

##   golden             runs the cases of reference/goldens/cases.txt again and compares; writes nothing
golden:
	$(Q)$(MAKE) $(BUILD)/touchstone-core
	$(Q)$(BUILD)/touchstone-core golden check $(T)

# Objects are made again when the compiler or its flags change.
$(BUILD)/flags: FORCE
	$(call keep,$(CC) $(CXX) $(C_FLAGS) $(CXX_FLAGS) $(CPP_LIBS))
$(BUILD)/obj/%.c.o: %.c $(BUILD)/flags
	$(call compile,CC)
$(BUILD)/obj/%.cc.o: %.cc $(BUILD)/flags
	$(call compile,CXX)
$(BUILD)/obj/$(ITEMS_C:.c=)/%.o: $(ITEMS_C) $(BUILD)/gen/items/%.def $(BUILD)/flags
	$(call compile,CC,$(GENERATED) -DITEMS='"kernels/$*.h"' -DITEMS_DEF='"items/$*.def"', ($*))
-include $(patsubst %.o,%.d,$(sort $(LIB_O) $(IMAGE_O) $(CLI_O) $(CORE_O)))

# A probe asks about one pixel, the command reads arguments, a study adds up figures, a file is read once: the compiler
# would work for longer than they do.
BRIEF := $(call object,$(wildcard src/methods/*/tools/*.c) \
	$(filter src/probe/% src/api/% src/cli/% src/study/% src/report/% src/scene/gltf/%,$(LIB_C) $(LIB_CC) $(CLI_C)))
$(BRIEF): OWN += $(if $(filter -O2 -O3,$(OPT)),-O1)
# Items are long and have few loops: they run no faster at -O3, which is theirs where somebody asks for it.
$(ITEMS_O): OWN := $(if $(filter file-O3,$(origin OPT)$(OPT)),-O2)

##   demo               install what is missing, build what it takes, render the mirrors of the atrium: out/demo.html
demo: DEVICES = $(file <$(BUILD)/gen/devices)
demo: deps-build
	$(Q)$(MAKE) all DEVICES='$(DEVICES)'
	build/touchstone render reflections atrium --method epr,ivir,mvr --truth=A,B --size 720x405 -o out/demo --force \
		--report out/demo.html
	$(say_left_out)

##   test               install what is missing, build, run the tests; T="PARTS OF NAMES"; also config=asan|ubsan|tsan
##   test-TIER          the same for a tier of tests/tiers.txt, which `test` leaves out: devices ports packages long
TEST_TIERS := $(patsubst %,test-%,$(shell sed -nE 's/^([a-z]+):.*/\1/p' tests/tiers.txt))
test $(TEST_TIERS): deps-test
	$(Q)$(MAKE) all tests
	$(Q)CC='$(CC)' CXX='$(CXX)' BUILD='$(BUILD)' scripts/run-tests \
		$(patsubst test-%,--tier %,$(filter-out test,$@)) $(T)

##   check              as test, but installs nothing and says what is missing; so do the others with TS_INSTALL=0
check:
	$(Q)TS_INSTALL=0 $(MAKE) test

tests: $(TESTS) $(PYTHON_PACKAGE)/made $(BUILD)/touchstone-core $(BUILD)/record/touchstone $(BUILD)/cuda/libcuda.so.1

##   style              the checks of the source text, and of the last commit's subject
##   format             clang-format, version 14, of the C and C++ sources; scripts/format-check compares only
style:
	$(Q)scripts/style-check
	$(Q)scripts/subjects
	$(Q)scripts/cite-check
	$(Q)scripts/lint-kernels
format:
	$(Q)scripts/format-check --write

deps-build deps-test:
	$(Q)scripts/install-deps $(@:deps-%=--%)

##   clean              removes build/
clean:
	rm -rf build

##   help               this list
help:
	@echo "make [TARGET] [config=release|debug|asan|ubsan|tsan|fuzz|coverage] [CC= CXX= CPPFLAGS= CFLAGS= CXXFLAGS="
	@echo "     LDFLAGS= OPT=] [WERROR=1 V=1 JOBS=N]"
	@sed -n 's/^##//p' Makefile scripts/make/install.mk scripts/make/tests.mk

.PHONY: all core golden demo test $(TEST_TIERS) check tests style format deps-build deps-test clean help FORCE
