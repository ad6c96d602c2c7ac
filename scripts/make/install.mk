# What is installed, by GNU's names of folders, each of which may be set; and what is packed: documents, the package for
# Python, tarball, wheel, a release.
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

# As it is installed: the module stands in libdir/touchstone as seen from bindir, wherever the prefix is moved to.
$(BUILD)/installed/touchstone: $(CLI_O) $(BUILD)/libtouchstone.a $(BUILD)/installed/dirs
	$(call link,$(FIND_MODULE)/$$(cat $(@D)/dirs))
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

.PHONY: docs python install uninstall installcheck dist wheel release
