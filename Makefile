# touchstone. `make help` lists the targets.
MAKEFLAGS += -r
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
# Where things are installed, by GNU's names: each may be set.
PREFIX ?= /usr/local
DESTDIR ?=
prefix = $(PREFIX)
exec_prefix = $(prefix)
bindir = $(exec_prefix)/bin
libdir = $(exec_prefix)/lib
includedir = $(prefix)/include
datarootdir = $(prefix)/share
datadir = $(datarootdir)
docdir = $(datarootdir)/doc/touchstone
mandir = $(datarootdir)/man
bashcompletiondir = $(datarootdir)/bash-completion/completions
zshcompletiondir = $(datarootdir)/zsh/site-functions
pythondir = $(exec_prefix)/lib/python3/dist-packages

SHOWN_NUMBERS := sed -n 's/^\#define TS_VERSION_[A-Z]* //p'
NUMBERS := $(shell $(SHOWN_NUMBERS) include/touchstone/status.h)
space := $(subst ,, )
VERSION := $(subst $(space),.,$(NUMBERS))
# Of the soname: a program that was built with 0.1 does not run with 0.2.
ABI := $(firstword $(NUMBERS))$(if $(filter 0,$(firstword $(NUMBERS))),.$(word 2,$(NUMBERS)))
PKG_CONFIG ?= pkg-config
JOBS ?= $(shell nproc)
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(JOBS)
endif
# For scripts that call make, which would ask this make for jobs, and be given one.
JOBS_OF_ITS_OWN := env -u MAKEFLAGS -u MAKELEVEL

# Configurations. OPT may be set: make OPT=-O0, make OPT="-O3 -march=native".
# With a sanitizer clang does not vectorize all that is asked for, and says so.
SANITIZE := -O1 -g1 -fno-omit-frame-pointer -Wno-pass-failed -fsanitize
ifeq ($(config),release)
OPT ?= -O3
else ifeq ($(config),debug)
OPT ?= -Og -g
else ifeq ($(config),asan)
OPT ?= $(SANITIZE)=address
else ifeq ($(config),ubsan)
OPT ?= $(SANITIZE)=undefined -fno-sanitize-recover=all
else ifeq ($(config),tsan)
# gcc's libgomp is not instrumented: clang's libomp tells the sanitizer its barriers through Archer.
CC := clang
CXX := clang++
OPT ?= $(SANITIZE)=thread
else ifeq ($(config),fuzz)
CC := clang
CXX := clang++
OPT ?= $(SANITIZE)=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
else ifeq ($(config),coverage)
OPT ?= -O0 -g --coverage
else
$(error config=$(config): one of release debug asan ubsan tsan fuzz coverage)
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
REPORTS ?= cli/reports study/results output/json
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
CPP_LIBS := -DTS_EMBREE=$(EMBREE) $(call packages,--cflags,OpenImageIO jansson libcrypto tinygltf zlib libzstd)
LIBS := $(call packages,--libs,jansson libcrypto zlib libzstd tinygltf) -ldl -lm
IMAGE_LIBS := $(call packages,--libs,OpenImageIO)
# These do without, or install it first.
WITHOUT := core %/touchstone-core golden demo test check test-% dist fuzz matrix matrix-short distros distros-short \
	mutants mutants-short mutants-src mutants-src-short faults faults-short release release-check style format \
	deps-build deps-test uninstall clean help
ifeq (,$(EMBREE))
ifneq (,$(filter-out $(WITHOUT),$(or $(MAKECMDGOALS),all)))
$(error Embree 3 or 4 is not installed: run scripts/install-deps (or make demo))
endif
endif

# The families of methods, the folders of kernels, and what is compiled for each folder.
FAMILIES := $(shell sed -n 's/^\#include FAMILY(\(.*\))/\1/p' src/families.def)
FOLDERS := vectors base $(FAMILIES)
ITEMS_C := src/backends/c/items.c
# The headers that have kernels, as points/splat: items.c is compiled for each.
ITEM_HEADERS := $(patsubst src/kernels/%.h,%,\
	$(shell grep -lE '^TS_(FN|CALL) void ts_k_\w+_item.const|^TS_VECTORS.\w+.$$' src/kernels/*/*.h))

# Sources, by folder.
every = $(wildcard $(foreach in,* */* */*/* */*/*/*,$(1)/$(in).$(2)))
LIB_C := $(filter-out src/cli/% $(ITEMS_C),$(call every,src,c))
IMAGE_CC := src/image/openimageio.cc
LIB_CC := $(filter-out $(IMAGE_CC),$(call every,src,cc))
CLI_C := $(filter-out src/cli/core/%,$(call every,src/cli,c))
CORE_C := $(wildcard $(patsubst %,src/%/*.c,model output backends backends/c backends/c/* methods methods/* families \
	golden vectors scene scene/builtin trace/emitted study/asked cli/core cli/line cli/golden $(REPORTS)))
CORE_C := $(filter-out $(ITEMS_C),$(CORE_C))
TEST_C := $(filter-out $(patsubst %,tests/%,$(shell sed '/^\#/d' tests/apart.txt)),$(call every,tests,c))

# Tests are one program by many names (tests/main.c), but for those that take arguments or define a function of libc or
# of the library. Linked into each: what tests begin with, and what lifts llvmpipe's limit of loops, which the driver
# finds by its name.
ALONE_C := $(patsubst %,tests/%.c,golden/file output/remove ports/candidate study/bench_start study/speed_limits)
TEST_ALSO_C := tests/begin.c tests/cli/preload/llvmpipe.c
LIFT := -Wl,--export-dynamic-symbol=LLVMBuildStore

object = $(patsubst %,$(BUILD)/obj/%.o,$(1))
ITEMS_O := $(ITEM_HEADERS:%=$(BUILD)/obj/$(ITEMS_C:.c=)/%.o)
LIB_O := $(call object,$(LIB_C) $(LIB_CC)) $(ITEMS_O)
IMAGE_O := $(call object,$(IMAGE_CC) $(patsubst %,src/model/%.c,error memory))
CLI_O := $(call object,$(CLI_C))
CLI_PARTS_O := $(filter-out %/main.c.o,$(CLI_O))
CORE_O := $(call object,$(CORE_C)) $(ITEMS_O)
TESTS := $(TEST_C:tests/%.c=$(BUILD)/tests/%)
ALL_O := $(sort $(LIB_O) $(IMAGE_O) $(CLI_O) $(CORE_O) \
	$(call object,$(TEST_C) tests/main.c $(TEST_ALSO_C) $(wildcard tests/fuzz/*.c)))

ifeq ($(V),0)
Q := @
say = @echo "  $(1)	$(2)"
endif

##   all (default)      libraries and the command: build/touchstone; with DEVICES= without the kernels of Vulkan, CUDA
##                      and `explain`
all: $(BUILD)/libtouchstone.a $(BUILD)/libtouchstone.so $(BUILD)/touchstone
	$(Q)ln -sfn $(patsubst build/%,%,$(BUILD))/touchstone build/touchstone
	$(say_left_out)

# What builds all kernels once more: two thirds of the work from an edit of a kernel to a picture.
ONCE_MORE := vulkan cuda explain
DEVICES ?= $(ONCE_MORE)
LEFT_OUT = $(filter-out $(DEVICES),$(ONCE_MORE))
say_left_out = $(if $(LEFT_OUT),@echo "left out: the kernels of $(LEFT_OUT); \`make\` builds them")
with = $(if $(filter $(1),$(DEVICES)),$(2))
$(BUILD)/gen/devices: FORCE
	$(call keep,$(DEVICES))

$(BUILD)/libtouchstone.a: $(LIB_O)
	$(call say,AR,$@)
	$(Q)rm -f $@ && $(AR) rcs $@ $^

# The map hides what C++ headers of other libraries make visible.
shared = $(CXX) $(LINK_FLAGS) -shared -Wl,-soname,$(1) -Wl,--version-script=$(filter %.map,$^) $(filter %.o,$^)
$(BUILD)/libtouchstone.so: $(LIB_O) scripts/exports.map | $(BUILD)/libtouchstone-image.so
	$(call say,LINK,$@)
	$(Q)$(call shared,$(@F).$(ABI)) $(FIND_MODULE):'$$ORIGIN/touchstone' $(LIBS) -o $@

$(BUILD)/libtouchstone-image.so: $(IMAGE_O) scripts/module.map
	$(call say,LINK,$@)
	$(Q)$(call shared,$(@F)) $(IMAGE_LIBS) -o $@

$(BUILD)/touchstone: $(CLI_O) $(BUILD)/libtouchstone.a | $(BUILD)/libtouchstone-image.so
	$(call say,LINK,$@)
	$(Q)$(CXX) $(LINK_FLAGS) $(FIND_MODULE) $^ $(LIBS) -o $@

# As it is installed: the module stands in libdir/touchstone as seen from bindir, wherever the prefix is moved to.
$(BUILD)/installed/touchstone: $(CLI_O) $(BUILD)/libtouchstone.a $(BUILD)/installed/dirs
	$(call say,LINK,$@)
	$(Q)$(CXX) $(LINK_FLAGS) $(FIND_MODULE)/$$(cat $(@D)/dirs) $(filter-out %/dirs,$^) $(LIBS) -o $@
$(BUILD)/installed/dirs: FORCE
	$(call keep,$(shell realpath -ms --relative-to=$(bindir) $(libdir)/touchstone))

# For pkg-config. Paths below the prefix follow where it is moved to.
below = $(patsubst $(prefix)/%,$${prefix}/%,$(1))
define TOUCHSTONE_PC
prefix=$(prefix)
libdir=$(call below,$(libdir))
includedir=$(call below,$(includedir))

Name: touchstone
Description: Bit-exact reference for many-view and point-based rendering
Version: $(VERSION)
Cflags: -I$${includedir}
Libs: -L$${libdir} -ltouchstone
Libs.private: $(filter -fopenmp,$(THREADED)) $(LIBS) -lstdc++ -Wl,-rpath,$${libdir}/touchstone
endef
export TOUCHSTONE_PC

# For find_package of CMake: a target with the shared library. Paths are found from where the file stands.
TO_INCLUDE := $(shell realpath -ms --relative-to=$(libdir)/cmake/touchstone $(includedir))
define TOUCHSTONE_CMAKE
if(NOT TARGET touchstone::touchstone)
  add_library(touchstone::touchstone SHARED IMPORTED)
  set_target_properties(touchstone::touchstone PROPERTIES
    IMPORTED_LOCATION "$${CMAKE_CURRENT_LIST_DIR}/../../libtouchstone.so.$(ABI)"
    INTERFACE_INCLUDE_DIRECTORIES "$${CMAKE_CURRENT_LIST_DIR}/$(TO_INCLUDE)")
endif()
endef
define TOUCHSTONE_CMAKE_VERSION
set(PACKAGE_VERSION $(VERSION))
string(FIND "$${PACKAGE_FIND_VERSION}." "$(ABI)." at)
if(NOT at AND NOT PACKAGE_FIND_VERSION VERSION_GREATER PACKAGE_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
if(PACKAGE_FIND_VERSION VERSION_EQUAL PACKAGE_VERSION)
  set(PACKAGE_VERSION_EXACT TRUE)
endif()
endef
export TOUCHSTONE_CMAKE TOUCHSTONE_CMAKE_VERSION

##   core               static command for digests and goldens: build/core/touchstone-core
CORE_BUILD ?= $(if $(filter command%,$(origin BUILD)),$(BUILD),build/core)
# Neither clang's OpenMP runtime nor the sanitizers have static libraries.
CORE_STATIC = $(if $(findstring clang,$(CC))$(findstring -fsanitize,$(OPT)),,-static)
core:
	$(Q)$(MAKE) --no-print-directory BUILD=$(CORE_BUILD) $(CORE_BUILD)/touchstone-core

$(call object,src/cli/core/main.c): OWN := $(if $(REPORTS),-DTS_REPORTS)
# The linker warns that libcrypto's name look-up needs shared libraries. Nothing here looks names up: show errors only.
$(BUILD)/touchstone-core: $(CORE_O)
	$(call say,LINK,$@)
	$(Q)said=$$($(CC) $(LINK_FLAGS) $(CORE_STATIC) $^ $(CORE_LIBS) -o $@ 2>&1) || { echo "$$said"; exit 1; }

# The fast paths whose kernels have the text that they were written for.
FAST_PATHS := $(BUILD)/gen/fast.inc
$(FAST_PATHS): scripts/fast-paths src/backends/kernels.h src/families.def include/touchstone/records.def \
		$(wildcard src/kernels/*/* src/backends/c/*/fast.def)
	$(Q)mkdir -p $(@D)
	$(Q)CC='$(CC)' scripts/fast-paths $@
$(call object,src/backends/c/run.c src/backends/fast.c): $(FAST_PATHS)
$(call object,src/backends/fast.c): OWN := -I$(BUILD)/gen
# And what a trace says of its maker.
$(call object,src/backends/c/run.c): OWN := -I$(BUILD)/gen -DTS_FLAGS='"-std=c11 $(OPT) $(EXACT)"'
##   golden             runs the cases of reference/goldens/cases.txt again and compares; writes nothing
golden:
	$(Q)$(MAKE) --no-print-directory $(BUILD)/touchstone-core
	$(Q)$(BUILD)/touchstone-core golden check $(T)

# The kernels as the text of an OpenCL program.
PROGRAM := $(BUILD)/gen/program.inc
$(PROGRAM): scripts/opencl-program scripts/assembled src/backends/kernels.h src/backends/kernels.def \
		src/families.def $(wildcard src/kernels/*/*) include/touchstone/records.def
	$(call say,GEN,$@)
	$(Q)mkdir -p $(@D)
	$(Q)scripts/opencl-program > $@
$(call object,src/backends/opencl/program.c): $(PROGRAM)
$(call object,src/backends/opencl/program.c): OWN := -I$(BUILD)/gen

# The same as GLSL: plain for porters, guarded for the backend; and as SPIR-V.
GLSL := $(BUILD)/gen/glsl
PLAIN := $(BUILD)/gen/plain
SPIRV := $(BUILD)/gen/spirv.inc
$(GLSL)/made $(PLAIN)/made: scripts/glsl $(wildcard scripts/kernel/*) $(wildcard src/backends/vulkan/*.glsl) \
		src/backends/kernels.h src/backends/kernels.def src/families.def $(wildcard src/kernels/*/*) \
		include/touchstone/records.def
	$(call say,GEN,$(@D))
	$(Q)rm -rf $(@D) && scripts/glsl $(if $(filter $(GLSL)/made,$@),--guarded) $(@D) && touch $@
$(SPIRV): scripts/vulkan-program scripts/kernel/packed.py scripts/spirv-exact $(BUILD)/gen/devices \
		$(call with,vulkan,$(GLSL)/made)
	$(call say,GEN,$@)
	$(Q)scripts/vulkan-program $(call with,vulkan,$(GLSL) $(BUILD)/gen/spirv) > $@
$(call object,src/backends/vulkan/program.c): $(SPIRV)
$(call object,src/backends/vulkan/program.c): OWN := -I$(BUILD)/gen

# The page of a report, before and behind its data.
PAGE := $(BUILD)/gen/page.inc
$(PAGE): scripts/report-page $(wildcard src/report/page/*)
	$(call say,GEN,$@)
	$(Q)mkdir -p $(@D)
	$(Q)scripts/report-page > $@
$(call object,src/report/page.c): $(PAGE)
$(call object,src/report/page.c): OWN := -I$(BUILD)/gen

# As C that tells what it computes.
EXPLAINED := $(BUILD)/gen/explained.inc
$(EXPLAINED): scripts/explained $(wildcard scripts/kernel/*) src/backends/kernels.h src/families.def \
		$(wildcard src/kernels/*/*) include/touchstone/records.def
	$(call say,GEN,$@)
	$(Q)mkdir -p $(@D)
	$(Q)scripts/explained > $@
$(call object,src/explain/kernels.c): $(BUILD)/gen/devices $(call with,explain,$(EXPLAINED))
# What tells spends its time in telling: higher levels take twice as long to compile and more, and it runs no faster. It
# tells values that it does not use.
$(call object,src/explain/kernels.c): OWN := $(if $(call with,explain,yes),,-DTS_LEFT_OUT) -I$(BUILD)/gen \
	-Wno-unused-value $(if $(filter -O2 -O3,$(OPT)),-Og)

# And as pseudo-code.
PSEUDOCODE := $(BUILD)/gen/pseudocode
$(PSEUDOCODE)/made: scripts/pseudocode $(wildcard scripts/kernel/*) src/backends/kernels.h src/families.def \
		$(wildcard src/kernels/*/*) include/touchstone/records.def
	$(call say,GEN,$(@D))
	$(Q)rm -rf $(@D) && scripts/pseudocode $(@D) && touch $@

# And as PTX, by clang where there is one: a file for each folder, packed; and one of all, to be installed.
CLANG := $(notdir $(shell command -v clang))
$(BUILD)/gen/clang: FORCE
	$(call keep,$(CLANG))
ALL_PTX := $(if $(CLANG),$(BUILD)/gen/kernels.ptx)
PTX := $(if $(CLANG),$(call with,cuda,$(FOLDERS:%=$(BUILD)/gen/kernels.%.ptx)))
$(PTX) $(ALL_PTX): scripts/ptx src/backends/cuda/entries.cu
	$(call say,GEN,$@)
	$(Q)mkdir -p $(@D)
	$(Q)scripts/ptx $@ $(patsubst %,-DOF=%,$(filter $(FOLDERS),$(subst ., ,$(@F)))) -MMD -MP
-include $(patsubst %.ptx,%.d,$(PTX) $(ALL_PTX))
PACKED_PTX := $(BUILD)/gen/ptx.inc
$(PACKED_PTX): scripts/cuda-program scripts/kernel/packed.py $(BUILD)/gen/clang $(BUILD)/gen/devices \
		src/backends/kernels.def src/families.def $(PTX)
	$(call say,GEN,$@)
	$(Q)scripts/cuda-program $(BUILD)/gen/ptx $(PTX) > $@
$(call object,src/backends/cuda/program.c): $(PACKED_PTX)
$(call object,src/backends/cuda/program.c): OWN := -I$(BUILD)/gen

# Writes the text to a file that does not have it yet: what depends on the file is made again when the text changes.
define keep
$(Q)mkdir -p $(@D)
$(Q)echo '$(1)' | cmp -s - $@ || echo '$(1)' > $@
endef

# The manual, of what the command says by itself.
MANUAL := $(BUILD)/gen/manual
$(MANUAL)/made: scripts/manual $(BUILD)/touchstone
	$(call say,GEN,$(@D))
	$(Q)rm -rf $(@D) && SOURCE_DATE_EPOCH='$(SOURCE_DATE_EPOCH)' scripts/manual $(BUILD)/touchstone $(@D) && touch $@

##   docs               the documents, headers and manual as pages for a browser: build/docs/index.html; needs pandoc
docs: $(MANUAL)/made
	$(Q)scripts/site $(MANUAL) build/docs
	$(Q)scripts/links-check build/docs
	@echo build/docs/index.html

# The package for Python: its sources, what it reads of the headers, and the name of the library.
PYTHON_PACKAGE := $(BUILD)/python/touchstone
PYTHON_SOURCES := $(wildcard src/python/touchstone/*.py) src/python/touchstone/py.typed
$(PYTHON_PACKAGE)/made: $(PYTHON_SOURCES) $(wildcard include/touchstone/*) scripts/abi $(BUILD)/flags
	$(call say,PYTHON,$(@D))
	$(Q)mkdir -p $(@D) && install -m 644 $(PYTHON_SOURCES) $(@D)
	$(Q)CC='$(CC)' scripts/abi --declarations > $(@D)/declarations.h
	$(Q)echo libtouchstone.so.$(ABI) > $(@D)/soname && touch $@

##   python             the package for Python with the library of this build, and how to import it
python: all $(PYTHON_PACKAGE)/made
	@echo "PYTHONPATH='$$(realpath $(BUILD)/python)' python3"

# A probe asks about one pixel, the command reads arguments, a study adds up figures, a file is read once: the compiler
# would work for longer than they do.
BRIEF := $(call object,$(wildcard src/methods/*/tools/*.c) \
	$(filter src/probe/% src/api/% src/cli/% src/study/% src/report/% src/scene/gltf/%,$(LIB_C) $(LIB_CC) $(CLI_C)))
$(BRIEF): OWN += $(if $(filter -O2 -O3,$(OPT)),-O1)
# Items are long and have few loops: they run no faster at -O3, which is theirs where somebody asks for it.
$(ITEMS_O): OWN := $(if $(filter file-O3,$(origin OPT)$(OPT)),-O2)

# Objects are made again when the compiler or its flags change.
$(BUILD)/flags: FORCE
	$(call keep,$(CC) $(CXX) $(C_FLAGS) $(CXX_FLAGS) $(CPP_LIBS))

# What is being built: a commit, when it was made, and whether its source was changed since. In a tarball, whose files
# are as old as the commit, .commit says which.
BUILT := $(shell { if [ -e .git ]; then \
		git -c log.showSignature=false log -1 --format='%H %ct' && \
		git --no-optional-locks status --porcelain -- src include Makefile; \
	else grep -v Format .commit && find src include Makefile -type f -newer .commit; fi; } 2>/dev/null)
COMMIT := $(or $(firstword $(BUILT))$(and $(word 3,$(BUILT)),-dirty),unknown)
# What is dated has this date.
SOURCE_DATE_EPOCH ?= $(word 2,$(BUILT))
$(BUILD)/commit: FORCE
	$(call keep,$(COMMIT))
$(call object,src/model/commit.c): $(BUILD)/commit
$(call object,src/model/commit.c): OWN := -DTS_COMMIT='"$(COMMIT)"'

# OWN: flags of single objects. Not added to CPPFLAGS or OPT: what a user gives those on the command line cannot be
# added to.
$(BUILD)/obj/%.c.o: %.c $(BUILD)/flags
	$(call say,CC,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(C_FLAGS) $(CPP_LIBS) $(OWN) -c $< -o $@

# The rows of the kernels that stand in a header.
$(BUILD)/gen/items/%.def: src/kernels/%.h $(wildcard src/kernels/*/kernels.def)
	$(Q)mkdir -p $(@D)
	$(Q)sed -nE 's/^TS_(FN|CALL) void ts_k_(\w+)_item\(.*/\2/p; s/^TS_VECTORS\((\w+)\)/\1/p' $< | \
		while read -r kernel; do grep "^KERNEL($$kernel," $(<D)/kernels.def || exit; done > $@
.PRECIOUS: $(BUILD)/gen/items/%.def
$(BUILD)/obj/$(ITEMS_C:.c=)/%.o: $(ITEMS_C) $(BUILD)/gen/items/%.def $(BUILD)/flags
	$(call say,CC,$< ($*))
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(C_FLAGS) $(OWN) -I$(BUILD)/gen -DITEMS='"kernels/$*.h"' -DITEMS_DEF='"items/$*.def"' -c $< -o $@

$(BUILD)/obj/%.cc.o: %.cc $(BUILD)/flags
	$(call say,CXX,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(CXX) $(CXX_FLAGS) $(CPP_LIBS) $(OWN) -c $< -o $@

-include $(ALL_O:.o=.d)

##   demo               install what is missing, build what it takes, render the mirrors of the atrium: out/demo.html
demo: DEVICES = $(file <$(BUILD)/gen/devices)
demo: deps-build
	$(Q)$(MAKE) --no-print-directory all DEVICES='$(DEVICES)'
	build/touchstone render reflections atrium --method epr,ivir,mvr --truth=A,B --size 720x405 -o out/demo --force \
		--report out/demo.html
	$(say_left_out)

##   test               install what is missing, build, run the tests; T="PARTS OF NAMES"; also config=asan|ubsan|tsan
##   test-TIER          the same for a tier of tests/tiers.txt, which `test` leaves out: devices ports packages long
TEST_TIERS := $(patsubst %,test-%,$(shell sed -nE 's/^([a-z]+):.*/\1/p' tests/tiers.txt))
test $(TEST_TIERS): deps-test
	$(Q)$(MAKE) --no-print-directory all tests
	$(Q)CC='$(CC)' CXX='$(CXX)' BUILD='$(BUILD)' scripts/run-tests \
		$(patsubst test-%,--tier %,$(filter-out test,$@)) $(T)

##   check              as test, but installs nothing and says what is missing; so do the others with TS_INSTALL=0
check:
	$(Q)TS_INSTALL=0 $(MAKE) --no-print-directory test

tests: $(TESTS) $(PYTHON_PACKAGE)/made $(BUILD)/touchstone-core $(BUILD)/record/touchstone $(BUILD)/cuda/libcuda.so.1

# Most of them run for less time than -O3 takes to compile them.
$(BUILD)/obj/tests/%: OWN = -O1 -Dmain=test_$(subst /,_,$(patsubst $(BUILD)/obj/tests/%.c.o,%,$@))
$(call object,tests/main.c $(ALONE_C)): OWN := -O1 -I$(BUILD)/gen
TEST_LIST := $(BUILD)/gen/tests.inc
TEST_ROWS := $(foreach test,$(filter-out $(ALONE_C),\
	$(TEST_C)),TEST($(subst /,_,$(test:tests/%.c=%)), "$(test:tests/%.c=%)"))
$(TEST_LIST): FORCE
	$(call keep,$(TEST_ROWS))
$(call object,tests/main.c): $(TEST_LIST)

FIND_ABOVE := $(FIND_MODULE):'$$ORIGIN/..:$$ORIGIN/../..:$$ORIGIN/../../..:$$ORIGIN/../../../..'
define LINK_TEST
	$(call say,LINK,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(CXX) $(LINK_FLAGS) $(LIFT) $(FIND_ABOVE) $(filter %.o %.a,$^) $(LIBS) -lcmocka \
		$(call packages,--libs,OpenCL) -o $@
endef
TEST_LINKS := $(call object,$(TEST_ALSO_C)) $(CLI_PARTS_O) $(BUILD)/libtouchstone.a
ALONE := $(ALONE_C:tests/%.c=$(BUILD)/tests/%)
$(ALONE): $(BUILD)/tests/%: $(BUILD)/obj/tests/%.c.o $(TEST_LINKS) | $(BUILD)/libtouchstone-image.so
	$(LINK_TEST)
$(BUILD)/tests/all: $(call object,tests/main.c $(filter-out $(ALONE_C),$(TEST_C))) $(TEST_LINKS) \
		| $(BUILD)/libtouchstone-image.so
	$(LINK_TEST)
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
	$(call say,CC,$<)
	$(Q)mkdir -p $(@D)
	$(Q)$(CC) $(C_FLAGS) $(CPP_LIBS) -O1 -DTS_RECORD_PARAMS $(OWN) -c $< -o $@
$(BUILD)/record/touchstone: $(RECORD_O) $(filter-out $(call object,$(RECORD_C)),$(CLI_O) $(LIB_O)) \
		| $(BUILD)/libtouchstone-image.so
	$(call say,LINK,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(CXX) $(LINK_FLAGS) $(FIND_MODULE):'$$ORIGIN/..' $^ $(LIBS) -o $@
-include $(RECORD_O:.o=.d)

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
	$(call say,LINK,$@)
	$(Q)mkdir -p $(@D)
	$(Q)$(CXX) $(LINK_FLAGS) -fsanitize=fuzzer $(FIND_ABOVE) $^ $(LIBS) -o $@
fuzz: deps-test
	$(Q)$(MAKE) --no-print-directory all
	$(Q)$(MAKE) --no-print-directory config=fuzz $(FUZZ_BIN)
	$(Q)scripts/fuzz-seeds
	$(Q)mkdir -p $(FUZZ:%=build/fuzz/corpus/%)
	$(Q)for target in $(FUZZ); do \
		LSAN_OPTIONS=suppressions=scripts/lsan.supp build/fuzz/tests/fuzz/$$target $(FUZZ_FLAGS) -max_len=65536 \
			build/fuzz/corpus/$$target build/fuzz/seeds/$$target || exit 1; done

##   matrix             compilers x optimisation x threads x denormals x architectures: one digest list
##   matrix-short       the part of it that .ci/run runs
matrix matrix-short:
	$(Q)scripts/install-deps --matrix
	$(Q)$(JOBS_OF_ITS_OWN) scripts/matrix $(if $(filter matrix-short,$@),--short)

##   distros            chroots of Debian 12 and 13: builds, traces, packages, each gcc and clang that they carry
##   distros-short      the part of it that .ci/run runs
distros distros-short:
	$(Q)$(JOBS_OF_ITS_OWN) scripts/distros $(if $(filter distros-short,$@),--short)

##   mutants            defects planted in sources and traces: each must be found where it was planted
##   mutants-short      the part of it that .ci/run runs
mutants mutants-short: deps-test
	$(Q)$(MAKE) --no-print-directory all
	$(Q)BUILD='$(BUILD)' COMPILE='$(CC) $(C_FLAGS) $(CPP_LIBS)' \
		LINK="$(CXX) $(LINK_FLAGS) -Wl,-rpath,'$(abspath $(BUILD))'" \
		WITH='$(CLI_O) $(BUILD)/libtouchstone.a $(LIBS)' scripts/mutants $(if $(filter %-short,$@),--short) $(T)

##   mutants-src        mutants of src/, each run by the tests that reach it, and how many they kill;
##                      T="PARTS OF NAMES"; an hour
##   mutants-src-short  the part of it that .ci/run runs
mutants-src mutants-src-short:
	$(Q)scripts/install-deps --matrix
	$(Q)$(MAKE) --no-print-directory all tests
	$(Q)BUILD='$(BUILD)' FLAGS='$(CPP_LIBS)' $(JOBS_OF_ITS_OWN) \
		scripts/mutants-src $(if $(filter %-short,$@),--short) $(T)

##   faults             calls that fail, one by one, in small commands; T="COMMANDS OR KINDS"; most of an hour
##   faults-short       the part of it that .ci/run runs
faults faults-short: deps-test
	$(Q)$(MAKE) --no-print-directory all
	$(Q)CC='$(CC)' BUILD='$(BUILD)' scripts/faults $(if $(filter %-short,$@),--short) $(T)

##   release-check      what a release must pass beside .ci/run: all of tests with TS_WHOLE=1, faults, matrix, distros,
##                      mutants, mutants-src, fresh mutants, and the tests with each sanitizer; hours
release-check:
	$(Q)scripts/install-deps --matrix
	$(Q)for part in test test-long faults matrix distros mutants mutants-src; do \
		TS_WHOLE=1 $(MAKE) --no-print-directory $$part || exit; done
	$(Q)$(MAKE) --no-print-directory mutants-src T='--fresh commit'
	$(Q)for config in asan ubsan tsan; do $(MAKE) --no-print-directory test config=$$config || exit; done

##   bench              the papers' tables, measured here, and every backend on one frame
bench: all
	for table in $$(build/touchstone list benches | awk 'NR > 1 && /^[a-z]/ { print $$1 }'); do \
		build/touchstone bench $$table || exit; done

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

##   install uninstall  under DESTDIR, in PREFIX=/usr/local or GNU's directories: prefix bindir libdir docdir mandir ...
ifneq (,$(filter install uninstall installcheck,$(MAKECMDGOALS)))
$(foreach folder,bindir libdir includedir datadir docdir mandir bashcompletiondir zshcompletiondir pythondir,\
	$(if $(filter 1,$(words $($(folder)))),,$(error $(folder)="$($(folder))": a folder without blanks would be right)))
$(if $(word 2,$(DESTDIR)),$(error DESTDIR="$(DESTDIR)": a folder without blanks would be right))
endif
BIN := $(DESTDIR)$(bindir)
LIB := $(DESTDIR)$(libdir)
INCLUDE := $(DESTDIR)$(includedir)/touchstone
DATA := $(DESTDIR)$(datadir)/touchstone
DOC := $(DESTDIR)$(docdir)
MAN := $(DESTDIR)$(mandir)/man1
BASH_COMPLETION := $(DESTDIR)$(bashcompletiondir)
ZSH_COMPLETION := $(DESTDIR)$(zshcompletiondir)
PYTHON := $(DESTDIR)$(pythondir)/touchstone
REFERENCE := $(filter-out reference/RECIPES.md reference/PICTURES.md,\
	$(wildcard $(patsubst %,reference/*.%,md json png)))
FAMILY_PAGES := $(wildcard reference/methods/*.md)
COMMANDS := $(shell sed -nE 's/^\t\{"([a-z]+)",.*/\1/p' src/cli/commands.c)
install: all $(BUILD)/installed/touchstone $(MANUAL)/made $(PLAIN)/made $(PSEUDOCODE)/made $(ALL_PTX) \
		$(PYTHON_PACKAGE)/made
	install -d $(BIN) $(LIB)/pkgconfig $(LIB)/cmake/touchstone $(LIB)/touchstone $(INCLUDE) $(DATA)/scenes \
		$(DATA)/ports/vulkan $(DATA)/examples $(DOC)/reference/methods $(MAN) \
		$(BASH_COMPLETION) $(ZSH_COMPLETION) $(PYTHON)
	install -m 755 $(BUILD)/installed/touchstone $(BIN)/touchstone
	install -m 644 $(BUILD)/libtouchstone.a $(LIB)/libtouchstone.a
	install -m 755 $(BUILD)/libtouchstone.so $(LIB)/libtouchstone.so.$(VERSION)
	install -m 755 $(BUILD)/libtouchstone-image.so $(LIB)/touchstone
	ln -sfn libtouchstone.so.$(VERSION) $(LIB)/libtouchstone.so.$(ABI)
	ln -sfn libtouchstone.so.$(ABI) $(LIB)/libtouchstone.so
	printf '%s\n' "$$TOUCHSTONE_PC" | install -m 644 /dev/stdin $(LIB)/pkgconfig/touchstone.pc
	printf '%s\n' "$$TOUCHSTONE_CMAKE" | install -m 644 /dev/stdin $(LIB)/cmake/touchstone/touchstoneConfig.cmake
	printf '%s\n' "$$TOUCHSTONE_CMAKE_VERSION" | \
		install -m 644 /dev/stdin $(LIB)/cmake/touchstone/touchstoneConfigVersion.cmake
	install -m 644 $(wildcard include/touchstone/*.h) $(INCLUDE)
	scripts/assembled include/touchstone/records.def | install -m 644 /dev/stdin $(INCLUDE)/records.def
	install -m 755 scripts/spirv-exact $(DATA)/spirv-exact
	$(if $(ALL_PTX),install -m 644 $(ALL_PTX) $(DATA)/kernels.ptx)
	rm -rf $(DATA)/glsl
	cp -R $(PLAIN) $(DATA)/glsl
	rm $(DATA)/glsl/made
	chmod -R u=rwX,go=rX $(DATA)/glsl
	install -m 644 $(wildcard scenes/*) $(DATA)/scenes
	install -m 644 $(wildcard tests/ports/vulkan/*) $(DATA)/ports/vulkan
	install -m 644 $(wildcard tests/api/example/*) $(DATA)/examples
	install -m 644 $(MANUAL)/*.1 $(MAN)
	install -m 644 scripts/completion $(BASH_COMPLETION)/touchstone
	install -m 644 scripts/completion $(ZSH_COMPLETION)/_touchstone
	install -m 644 $(PYTHON_SOURCES) $(PYTHON_PACKAGE)/declarations.h \
		$(PYTHON_PACKAGE)/soname $(PYTHON)
	install -m 644 README.md CHANGELOG.md LICENSE $(DOC)
	rm -rf $(DOC)/kernels
	cp -R $(PSEUDOCODE) $(DOC)/kernels
	rm $(DOC)/kernels/made
	chmod -R u=rwX,go=rX $(DOC)/kernels
	install -m 644 $(REFERENCE) $(DOC)/reference
	install -m 644 $(FAMILY_PAGES) $(DOC)/reference/methods
uninstall:
	rm -f $(BIN)/touchstone $(LIB)/pkgconfig/touchstone.pc $(MAN)/touchstone.1 $(COMMANDS:%=$(MAN)/touchstone-%.1)
	rm -f $(BASH_COMPLETION)/touchstone $(ZSH_COMPLETION)/_touchstone
	rm -f $(patsubst %,$(LIB)/libtouchstone%,.a .so .so.$(ABI) .so.$(VERSION))
	rm -rf $(LIB)/touchstone $(LIB)/cmake/touchstone $(INCLUDE) $(DATA) $(DOC)/kernels $(PYTHON)
	rm -f $(addprefix $(DOC)/,README.md CHANGELOG.md LICENSE $(REFERENCE) $(FAMILY_PAGES))
	for folder in $(DOC)/reference/methods $(DOC)/reference $(DOC); do \
		[ ! -d $$folder ] || rmdir --ignore-fail-on-non-empty $$folder; done

##   installcheck       judges what is installed there: command, libraries, pkg-config, manual, completion; uninstall
installcheck: | $(filter install,$(MAKECMDGOALS))
	$(Q)MAKE='$(MAKE)' BUILD='$(BUILD)' CC='$(CC)' CXX='$(CXX)' PKG_CONFIG='$(PKG_CONFIG)' DESTDIR='$(DESTDIR)' \
		prefix='$(prefix)' BIN='$(BIN)' LIB='$(LIB)' INCLUDE='$(INCLUDE)' PYTHON='$(PYTHON)' ABI='$(ABI)' MAN='$(MAN)' \
		BASH_COMPLETION='$(BASH_COMPLETION)' ZSH_COMPLETION='$(ZSH_COMPLETION)' scripts/installcheck

##   dist               build/touchstone-VERSION.tar.xz of the last commit, the same bytes each time
NUMBERS_OF_HEAD = $(shell git show HEAD:include/touchstone/status.h 2>/dev/null | $(SHOWN_NUMBERS))
DIST = build/touchstone-$(subst $(space),.,$(NUMBERS_OF_HEAD))
dist:
	$(Q)[ -e .git ] || { echo "make dist: no git checkout here, whose last commit would be packed" >&2; exit 2; }
	$(Q)command -v xz > /dev/null || \
		{ echo "make dist: no xz here; scripts/install-deps --test installs it" >&2; exit 2; }
	$(Q)mkdir -p build && part=$(DIST).$$$$.tar && trap 'rm -f $$part $$part.xz' EXIT && \
		git -c tar.umask=0022 archive --prefix=$(notdir $(DIST))/ -o $$part HEAD && \
		env -u XZ_OPT -u XZ_DEFAULTS xz -T1 -2 -f $$part && mv -f $$part.xz $(DIST).tar.xz
	@echo $(DIST).tar.xz

##   wheel              build/touchstone-VERSION-py3-none-PLATFORM.whl: the package for Python with the library,
##                      the same bytes each time
wheel: $(BUILD)/libtouchstone.so $(BUILD)/libtouchstone-image.so $(PYTHON_PACKAGE)/made
	$(Q)scripts/wheel $(BUILD) $(VERSION) build

##   release            what a tag carries: tarball, static core, packages, wheel, documents and their digests,
##                      in build/dist; T="PARTS"
release:
	$(Q)MAKE='$(MAKE)' $(JOBS_OF_ITS_OWN) scripts/release $(T)

##   clean              removes build/
clean:
	rm -rf build

##   help               this list
help:
	@echo "make [TARGET] [config=release|debug|asan|ubsan|tsan|fuzz|coverage] [CC= CXX= CPPFLAGS= CFLAGS= CXXFLAGS="
	@echo "     LDFLAGS= OPT=] [WERROR=1 V=1 JOBS=N]"
	@sed -n 's/^##//p' $(firstword $(MAKEFILE_LIST))

FORCE:
.PHONY: all core golden demo test $(TEST_TIERS) check tests fuzz matrix matrix-short distros distros-short mutants \
	mutants-short mutants-src mutants-src-short faults faults-short release-check bench style format deps-build \
	deps-test install uninstall installcheck dist wheel release python docs clean help FORCE
