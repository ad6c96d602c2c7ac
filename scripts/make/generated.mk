# Sources that are made before they are compiled, below $(BUILD)/gen: tables, texts of kernels, a page; and the manual.

# What builds all kernels once more: two thirds of the work from an edit of a kernel to a picture.
ONCE_MORE := vulkan cuda explain
DEVICES ?= $(ONCE_MORE)
LEFT_OUT = $(filter-out $(DEVICES),$(ONCE_MORE))
say_left_out = $(if $(LEFT_OUT),@echo "left out: the kernels of $(LEFT_OUT); \`make\` builds them")
with = $(if $(filter $(1),$(DEVICES)),$(2))
$(BUILD)/gen/devices: FORCE
	$(call keep,$(DEVICES))

# What a command prints; and a folder that a command fills.
define generate
$(call say,GEN,$@)
$(Q)mkdir -p $(@D)
$(Q)$(1) > $@
endef
define generate_folder
$(call say,GEN,$(@D))
$(Q)rm -rf $(@D) && $(1) $(@D) && touch $@
endef

# Which sources include what is generated, and flags that they have beside.
GENERATED := -I$(BUILD)/gen
$(call object,$(patsubst %,src/%.c,backends/fast $(patsubst %,backends/%/program,opencl vulkan cuda) report/page \
		study/tables/tables)): \
	OWN := $(GENERATED)

# Of all kernels; the rows of those that stand in a header.
KERNELS := src/backends/kernels.h src/families.def $(wildcard src/kernels/*/*) include/touchstone/records.def
KERNELS_C := $(wildcard scripts/kernel/*.*) $(KERNELS)
$(BUILD)/gen/items/%.def: src/kernels/%.h $(wildcard src/kernels/*/kernels.def)
	$(Q)mkdir -p $(@D)
	$(Q)sed -nE 's/^TS_(FN|CALL) void ts_k_(\w+)_item\(.*/\2/p; s/^TS_VECTORS\((\w+)\)/\1/p' $< | \
		while read -r kernel; do grep "^KERNEL($$kernel," $(<D)/kernels.def || exit; done > $@
.PRECIOUS: $(BUILD)/gen/items/%.def

# The fast paths whose kernels have the text that they were written for.
FAST_PATHS := $(BUILD)/gen/fast.inc
$(FAST_PATHS): scripts/fast-paths $(KERNELS) $(wildcard src/backends/c/*/fast.def)
	$(Q)mkdir -p $(@D)
	$(Q)CC='$(CC)' scripts/fast-paths $@
$(call object,src/backends/c/run.c src/backends/fast.c): $(FAST_PATHS)
# And what a trace says of its maker.
$(call object,src/backends/c/run.c): OWN := $(GENERATED) -DTS_FLAGS='"-std=c11 $(OPT) $(EXACT)"'

# The kernels as the text of an OpenCL program.
PROGRAM := $(BUILD)/gen/program.inc
$(PROGRAM): scripts/opencl-program scripts/assembled src/backends/kernels.def $(KERNELS)
	$(call generate,scripts/opencl-program)
$(call object,src/backends/opencl/program.c): $(PROGRAM)

# The same as GLSL: plain for porters, guarded for the backend; and as SPIR-V.
GLSL := $(BUILD)/gen/glsl
PLAIN := $(BUILD)/gen/plain
SPIRV := $(BUILD)/gen/spirv.inc
$(GLSL)/made $(PLAIN)/made: scripts/glsl $(wildcard src/backends/vulkan/*.glsl) src/backends/kernels.def $(KERNELS_C)
	$(call generate_folder,scripts/glsl $(if $(filter $(GLSL)/made,$@),--guarded))
$(SPIRV): scripts/vulkan-program scripts/kernel/packed.py scripts/spirv-exact $(BUILD)/gen/devices \
		$(call with,vulkan,$(GLSL)/made)
	$(call generate,scripts/vulkan-program $(call with,vulkan,$(GLSL) $(BUILD)/gen/spirv))
$(call object,src/backends/vulkan/program.c): $(SPIRV)

# As C that tells what it computes.
EXPLAINED := $(BUILD)/gen/explained.inc
$(EXPLAINED): scripts/explained $(KERNELS_C)
	$(call generate,scripts/explained)
$(call object,src/explain/kernels.c): $(BUILD)/gen/devices $(call with,explain,$(EXPLAINED))
# What tells spends its time in telling: higher levels take twice as long to compile and more, and it runs no faster. It
# tells values that it does not use.
$(call object,src/explain/kernels.c): OWN := $(if $(call with,explain,yes),,-DTS_LEFT_OUT) $(GENERATED) \
	-Wno-unused-value $(if $(filter -O2 -O3,$(OPT)),-Og)

# And as pseudo-code.
PSEUDOCODE := $(BUILD)/gen/pseudocode
$(PSEUDOCODE)/made: scripts/pseudocode $(KERNELS_C)
	$(call generate_folder,scripts/pseudocode)

# And as PTX, by clang where there is one: a file for each folder, packed; and one of all, to be installed.
FOLDERS := vectors base $(shell sed -n 's/^\#include FAMILY(\(.*\))/\1/p' src/families.def)
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
	$(call generate,scripts/cuda-program $(BUILD)/gen/ptx $(PTX))
$(call object,src/backends/cuda/program.c): $(PACKED_PTX)

# The page of a report, before and behind its data.
PAGE := $(BUILD)/gen/page.inc
$(PAGE): scripts/report-page $(wildcard src/report/page/*)
	$(call generate,scripts/report-page)
$(call object,src/report/page.c src/study/tables/tables.c): $(PAGE)

# The tables of `bench`, which are text.
TABLES := $(BUILD)/gen/tables.inc
$(TABLES): scripts/tables src/families.def $(wildcard src/methods/*/tables/*.table)
	$(call generate,scripts/tables)
$(call object,src/study/tables/tables.c): $(TABLES)

# The manual, of what the command says by itself.
MANUAL := $(BUILD)/gen/manual
$(MANUAL)/made: scripts/manual $(BUILD)/touchstone
	$(call generate_folder,SOURCE_DATE_EPOCH='$(SOURCE_DATE_EPOCH)' scripts/manual $(BUILD)/touchstone)

# What is being built: a commit, when it was made, and whether its source was changed since. In a tarball, whose files
# are as old as the commit, .commit says which.
SOURCE := src include Makefile scripts/make
BUILT := $(shell { if [ -e .git ]; then \
		git -c log.showSignature=false log -1 --format='%H %ct' && \
		git --no-optional-locks status --porcelain -- $(SOURCE); \
	else grep -v Format .commit && find $(SOURCE) -type f -newer .commit; fi; } 2>/dev/null)
COMMIT := $(or $(firstword $(BUILT))$(and $(word 3,$(BUILT)),-dirty),unknown)
# What is dated has this date.
SOURCE_DATE_EPOCH ?= $(word 2,$(BUILT))
$(BUILD)/commit: FORCE
	$(call keep,$(COMMIT))
$(call object,src/model/commit.c): $(BUILD)/commit
$(call object,src/model/commit.c): OWN := -DTS_COMMIT='"$(COMMIT)"'
