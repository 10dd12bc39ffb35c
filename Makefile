# SPDX-License-Identifier: MIT
# Builds, runs and tests superframe; everything that it makes goes under build/.
# `make help` lists the goals, `make V=1` shows whole commands.

# make's own default, cc, may be any compiler.
CC      := $(if $(filter default,$(origin CC)),gcc,$(CC))
OBJCOPY ?= objcopy
BUILD   ?= build
SCENE   ?= fig3
# Nothing is installed to install something.
SETUP   ?= $(if $(filter install uninstall,$(MAKECMDGOALS)),no,yes)
# Scripts find it in their environment. CC is another one for some targets, and is given where it is asked for.
export BUILD

WARNINGS := -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror
OPTIMISE ?= -O2
# Functions and lines, for reports and profiles; DEBUG=-g has variables too, and takes a third longer.
DEBUG    ?= -g1
# Golden images: no contraction to fused multiply-add, no excess precision.
FLOATING := -ffp-contract=off
# Files of more than 2 GiB where long has 32 bits.
POSIX    := -D_POSIX_C_SOURCE=200809L -D_FILE_OFFSET_BITS=64

# ---- What this machine has ----------------------------------------------------------------------

# Of packages: those that are there, where their headers are, how they are linked.
there      = $(foreach package,$(1),$(if $(shell pkg-config --exists '$(package)' 2>/dev/null && echo yes),$(package)))
headers_of = $(if $(1),$(subst -I,-isystem ,$(shell pkg-config --cflags-only-I $(1))))
libs_of    = $(if $(1),$(shell pkg-config --libs $(1)))

# f128 takes libquadmath and a compiler with its numbers; QUADMATH=no leaves it out.
QUADMATH ?= $(shell echo 'extern __float128 sqrtq(__float128); int main(int n, char **s) { return s && sqrtq(n) > 9; }' | \
    $(CC) -x c - -o /dev/null -lquadmath 2>/dev/null && echo yes)
F128 := $(if $(filter yes,$(QUADMATH)),f128)
ARITHMETICS := fx f32 f64 $(F128)
# For `superframe measure` alone: what fx is measured against.
EXAMPLES    := q16 q16_epsilon

# The ways to an adapter: USB_LIBUSB=no and USB_HIDAPI=no leave one out, USB_HIDAPI=hidapi-libusb
# takes the other flavour.
USB_PACKAGES := $(call there,$(or $(USB_LIBUSB),libusb-1.0) $(or $(USB_HIDAPI),hidapi-hidraw))
USB_LIBS     := $(call libs_of,$(USB_PACKAGES))
DRIVERS      := $(if $(filter libusb%,$(USB_PACKAGES)),bulk) $(if $(filter hidapi%,$(USB_PACKAGES)),hid)

# The CPU of `superframe boot`, loaded when a floppy is booted; BOOT_UNICORN=no leaves it out.
PROCESSORS := $(if $(call there,$(or $(BOOT_UNICORN),unicorn)),unicorn)

LIBS := -lpng -lxxhash -ldeflate $(F128:f128=-lquadmath) -lm -lpthread $(USB_LIBS) $(PROCESSORS:unicorn=-ldl)

# Streams of rays, for the arithmetics that CPUs have in vectors; fx as it suits vectors, with the
# same bits. Of the sets of instructions that are compiled for, one is taken at run time.
STREAM_REALS := f32 f64 fx
VECTOR_SETS  := $(if $(filter x86_64%,$(shell $(CC) -dumpmachine)),avx2 avx512)
ENGINES      := $(foreach real,$(STREAM_REALS) $(STREAM_REALS:%=%_many),$(patsubst %,$(real)_%,plain $(VECTOR_SETS)))

# ---- Sources ------------------------------------------------------------------------------------

FIRMWARE_SOURCES := $(wildcard firmware/*.c)
# Compiled once for each arithmetic beside the firmware.
PER_ARITHMETIC_SOURCES := $(wildcard host/render/per_arithmetic/*.c)
STREAM_SOURCES    = $(wildcard host/stream/*.c host/stream/$(1)/*.c) firmware/solids.c firmware/tail.c
# Both ends of the cable, and the board.
TESTKIT_SOURCES  := $(wildcard emulator/testing/*.c)
BOARD_SOURCES    := $(wildcard hal/*.c hal/cable/*.c firmware/adapter/*.c) \
                    $(filter-out $(TESTKIT_SOURCES),$(wildcard emulator/*/*.c))
LEFT_OUT         := $(patsubst %,adapter/driver_%,$(filter-out $(DRIVERS),bulk hid)) \
                    $(if $(PROCESSORS),,$(addprefix boot/,cpu_unicorn unicorn_code unicorn_library unicorn_rom unicorn_run)) \
                    $(if $(VECTOR_SETS),,render/instruction_sets_x86_64)
HOST_SOURCES     := $(filter-out host/stream/%.c $(patsubst %,host/%.c,$(LEFT_OUT) command/main), \
                    $(wildcard host/*/*.c host/lab/*/*.c))
# What this build has of several kinds: header, type, names. host/base/list.sh makes C of a list.
LISTS := commands arithmetics arithmetics_many stream_engines instruction_sets usb_backends processors
LIST_commands         := command/command.h command render scenes check compile export tree replay \
                         compare measure paper devices adapter trace boot completion manual help
LIST_arithmetics      := render/arithmetic.h arithmetic $(ARITHMETICS)
LIST_arithmetics_many := render/arithmetic.h arithmetic $(ARITHMETICS:%=%_many)
LIST_stream_engines   := render/engine.h stream_engine $(ENGINES)
LIST_instruction_sets := render/engine.h instruction_set $(VECTOR_SETS)
LIST_usb_backends     := adapter/drivers.h usb_backend $(DRIVERS)
LIST_processors       := boot/cpu.h processor $(PROCESSORS)
# The objects that a program takes what it calls from.
LIBRARY := $(patsubst %.c,%.o,$(BOARD_SOURCES) $(HOST_SOURCES)) builtin_scenes.o $(LISTS:%=lists/%.o) \
           $(patsubst %,arithmetic_%.o,$(ARITHMETICS) $(EXAMPLES) $(ARITHMETICS:%=%_many)) $(ENGINES:%=stream_engine_%.o)

INCLUDE_hal      := -Ihal -Ihal/cable
INCLUDE_firmware := $(INCLUDE_hal) -Ifirmware
INCLUDE_emulator := $(INCLUDE_hal) $(patsubst %,-Iemulator/%,board picture trace bus)
INCLUDE_host     := $(INCLUDE_emulator) -Ifirmware -Ifirmware/adapter -Ihost $(call headers_of,$(USB_PACKAGES))
# Where gcc keeps quadmath.h: clang links gcc's library but does not look among its headers.
INCLUDE_tests    := $(INCLUDE_host) -Iemulator/testing -Itests/fixtures -idirafter $(dir $(shell $(CC) -print-file-name=include/quadmath.h))
include_of        = $(INCLUDE_$(firstword $(subst /, ,$(1))))

# ---- How a thing is made ------------------------------------------------------------------------

# A configuration is one build of everything: release for use, library for others' programs,
# sanitized for the tests, fuzzed for the fuzzers, coverage for the count of branches.
CONFIGURATIONS := release library sanitized fuzzed coverage
CFLAGS_release   := $(OPTIMISE) $(DEBUG)
CFLAGS_library   := $(OPTIMISE) $(DEBUG) -fPIC
CFLAGS_sanitized := -O1 $(DEBUG) -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
CFLAGS_fuzzed    := $(CFLAGS_sanitized) -fsanitize=fuzzer-no-link,float-cast-overflow
CFLAGS_coverage  := -O0 -g --coverage

# say WORD: names what is made, where the command itself is not shown.
say = @$(if $(V),:,printf '  %-4s %s\n' '$(1)' '$(@:$(BUILD)/%=%)')
Q  := $(if $(V),,@)

# compile FLAGS: an object of its source; what its folder needs besides stands in FLAGS_folder. What is
# compiled for each arithmetic is named when it is put together.
define compile
@mkdir -p $(@D)
$(if $(findstring /arithmetic_,$@)$(findstring /stream_engine_,$@),,$(call say,CC))
$(Q)$(CC) $(WARNINGS) $(1) $(FLAGS_$(patsubst %/,%,$(dir $<))) -MMD -MP -c -o $@ $<
endef

# link MORE: a program of the objects and sources before it, and of what they call of archives.
define link
@mkdir -p $(@D)
$(call say,LD)
$(Q)$(CC) $(CFLAGS_$(firstword $(subst /, ,$(@:$(BUILD)/%=%)))) -Wl,--as-needed -o $@ $(filter %.c %.o,$^) $(filter %.a,$^) $(1)
endef

# combine SYMBOL: one object of several, of which only that symbol leaves.
define combine
$(call say,JOIN)
$(Q)$(CC) -r -nostdlib -o $@ $(filter %.o,$^)
$(Q)$(if $(1),$(OBJCOPY) --keep-global-symbol=$(1) $@)
endef

# renew COMMAND: what the command prints, in a file that keeps its time where nothing changes. Another make
# may be doing the same.
define renew
@mkdir -p $(@D)
@new=$@.$$$$; { $(1); } > $$new && if cmp -s $$new $@; then rm $$new; else mv $$new $@; fi
endef

# objects FOLDER,FLAGS[,WHERE]: what is compiled into a folder, of any source below WHERE.
define objects
$$(BUILD)/$(1)/%.o: $(3)%.c $$(BUILD)/flags | setup
	$$(call compile,$(2))

endef

# joined CONFIGURATION,NAME,SOURCES,FLAGS: an object of what is compiled in a folder of its own, NAME. The
# symbol of that name alone leaves it.
define joined
$(call objects,$(1)/$(2),$$(FLOATING) $$(CFLAGS_$(1)) $(4))
$$(BUILD)/$(1)/$(2).o: $(patsubst %.c,$$(BUILD)/$(1)/$(2)/%.o,$(3)) $$(BUILD)/sources
	$$(call combine,$(2))

endef

# Nothing here changes a result: no trap is waited for, no errno is read, no infinity is made in a lane that
# counts (strict/real.h), and no sign of a zero is asked for. In lanes, & is what && is elsewhere.
STREAM_FLAGS := -fno-trapping-math -fno-math-errno -ffinite-math-only -fno-signed-zeros -Wno-bitwise-instead-of-logical
# Two of gcc's passes make branches in loops that are to be vectors: they thread jumps through choices that
# hang together, and, in some files, look for partial redundancies. A third calls memcpy for short loops.
ifeq ($(findstring clang,$(shell $(CC) --version)),)
STREAM_FLAGS += -fno-thread-jumps -fno-tree-loop-distribute-patterns
$(foreach file,search_solids search_quadrics boundaries,$(eval STREAM_FLAGS_$(file) := -fno-tree-pre))
# A fourth one unrolls loops of NODE_WIDTH before they can become vectors.
STREAM_FLAGS_search := --param max-completely-peel-times=4
endif
# Under the sanitizers, checks between the lanes leave no vectors.
STREAM_FLAGS_release := $(OPTIMISE:-O2=-O3)
STREAM_FLAGS_sanitized := -O2
STREAM_FLAGS_avx2   := -march=x86-64-v3
STREAM_FLAGS_avx512 := -march=x86-64-v4 -mprefer-vector-width=512

# Sets of primitives are bits, or lists where a scene has many. The include path chooses.
SETS_bits := -Ifirmware/features/full -Ihost/render/sets/bits
SETS_list := -Ifirmware/features/many -Ihost/render/sets/list

# arithmetic CONFIGURATION,REAL,NAME,FLAGS: the firmware in an arithmetic, and what is compiled beside it.
arithmetic = $(call joined,$(1),$(3),$(FIRMWARE_SOURCES) $(PER_ARITHMETIC_SOURCES),\
    $(4) $$(if $$(filter firmware%,$$<),-ffreestanding) $(patsubst %,-I%,$(wildcard firmware/real/$(2) firmware/real/lab/$(2))) $$(call include_of,$$<))

# engine CONFIGURATION,REAL,INSTRUCTIONS,SUFFIX,SETS: streams of rays in an arithmetic, for a set of instructions.
engine = $(call joined,$(1),stream_engine_$(2)$(4)_$(3),$(call STREAM_SOURCES,$(5)),\
    $$(STREAM_FLAGS) $$(STREAM_FLAGS_$(1)) $$(STREAM_FLAGS_$$(*F)) $$(STREAM_FLAGS_$(3)) $(SETS_$(5)) -Ihost/stream/$(5) -Ifirmware/real/$(2:fx=fx_vector) -Ihost/stream/sets/$(3) $$(INCLUDE_host))

# configuration NAME: every object, compiled for it. The include path chooses arithmetic and instructions.
define configuration
$(call objects,$(1),$$(POSIX) $$(CFLAGS_$(1)) $$(call include_of,$$<))
$(call objects,$(1),$$(CFLAGS_$(1)) $$(INCLUDE_host),$$(BUILD)/)
$(foreach real,$(ARITHMETICS) $(EXAMPLES) count,$(call arithmetic,$(1),$(real),arithmetic_$(real),$(SETS_bits)))
$(foreach real,$(ARITHMETICS),$(call arithmetic,$(1),$(real),arithmetic_$(real)_many,$(SETS_list)))
$(foreach real,$(STREAM_REALS),$(foreach set,plain $(VECTOR_SETS),$(call engine,$(1),$(real),$(set),,bits)$(call engine,$(1),$(real),$(set),_many,list)))
endef

all: $(BUILD)/superframe ## Build the program (the default)

.DELETE_ON_ERROR:
# Objects are kept; .SECONDARY would leave out one that is missing where what needs it is newer.
.PRECIOUS: %.o %.c

$(foreach name,$(CONFIGURATIONS),$(eval $(call configuration,$(name))))

$(BUILD)/release/library.a $(BUILD)/sanitized/library.a: $(BUILD)/%/library.a: $(addprefix $(BUILD)/%/,$(LIBRARY))
# By q, objects with one name, from different folders, are all kept.
$(BUILD)/%.a: $(BUILD)/sources
	$(call say,AR)
	@rm -f $@
	$(Q)$(AR) qcs $@ $(filter %.o,$^)

$(patsubst %,$(BUILD)/%/superframe,release sanitized coverage): %/superframe: %/host/command/main.o %/library.a
	$(call link,$(LIBS))

$(BUILD)/superframe: $(BUILD)/release/superframe
	@cp $< $@.new && mv -f $@.new $@

# Compiler and flags of the last build: when they change, everything is compiled again.
$(BUILD)/flags: FORCE | setup
	$(call renew,echo '$(subst ','\'',$(CC) $(WARNINGS) $(FLOATING) $(CFLAGS_library) $(CFLAGS_fuzzed) $(STREAM_FLAGS) $(STREAM_FLAGS_sanitized))')

# The list of sources: when a file goes away, what was linked from it is linked again.
$(BUILD)/sources: FORCE
	$(call renew,echo $(BOARD_SOURCES) $(FIRMWARE_SOURCES) $(HOST_SOURCES))

# The built-in scenes' texts, as byte arrays, and the lists.
$(BUILD)/builtin_scenes.c: host/scene/embed.sh $(wildcard firmware/scenes/*.scene) FORCE
	$(call renew,sh $< $(filter %.scene,$^))

$(LISTS:%=$(BUILD)/lists/%.c): $(BUILD)/lists/%.c: host/base/list.sh FORCE
	$(call renew,sh $< $* $(LIST_$*))

# ---- The library --------------------------------------------------------------------------------

PREFIX  ?= /usr/local
LIBDIR  ?= $(PREFIX)/lib
INSTALL ?= install
VERSION := $(shell sed -n 's/^.define SUPERFRAME_VERSION "\(.*\)"/\1/p' host/command/command.h)
SONAME  := libsuperframe.so.$(firstword $(subst ., ,$(VERSION)))
# What a program that uses the library may include: all but the emulator's own.
PUBLIC_HEADERS := emulator/testing/testing.h $(filter-out %_internal.h, \
                  $(wildcard hal/*.h hal/cable/*.h firmware/adapter/*.h $(patsubst %,emulator/%/*.h,board picture trace bus)))
LIBRARIES := $(addprefix $(BUILD)/library/,libsuperframe.a $(SONAME) libsuperframe-testing.a)

library: $(LIBRARIES) ## Build libsuperframe, static and shared, and its test kit

$(filter-out %-testing.a,$(LIBRARIES)): $(BOARD_SOURCES:%.c=$(BUILD)/library/%.o)
$(filter %-testing.a,$(LIBRARIES)): $(TESTKIT_SOURCES:%.c=$(BUILD)/library/%.o)
SHARED := -shared -Wl,-soname,$(SONAME) -Wl,-z,defs -lpng -lxxhash -ldeflate
$(BUILD)/library/$(SONAME): $(BUILD)/sources
	$(call link,$(SHARED))

# What is installed, as FILE:FOLDER:MODE.
PC_FILES    := $(BUILD)/superframe.pc $(BUILD)/superframe-testing.pc
COMPLETIONS := $(addprefix $(BUILD)/completion/,bash/superframe zsh/_superframe fish/superframe.fish)
INSTALLED   := $(BUILD)/superframe:$(PREFIX)/bin:755 \
    $(foreach library,$(LIBRARIES),$(library):$(LIBDIR):$(if $(filter %.a,$(library)),644,755)) \
    $(PUBLIC_HEADERS:%=%:$(PREFIX)/include/superframe:644) \
    $(PC_FILES:%=%:$(LIBDIR)/pkgconfig:644) \
    host/adapter/70-superframe.rules:$(PREFIX)/lib/udev/rules.d:644 \
    $(foreach page,$(BUILD)/superframe.1 $(wildcard docs/*.[13]),$(page):$(PREFIX)/share/man/man$(subst .,,$(suffix $(page))):644) \
    $(join $(COMPLETIONS),$(patsubst %,:$(PREFIX)/share/%:644,bash-completion/completions zsh/site-functions fish/vendor_completions.d))
each_installed = for entry in $(INSTALLED); do file=$${entry%%:*}; mode=$${entry\#\#*:}; \
    folder='$(DESTDIR)'$${entry\#*:}; folder=$${folder%:*}; $(1); done

$(COMPLETIONS): $(BUILD)/superframe
	$(call renew,$< completion $(notdir $(@D)))
$(PC_FILES): $(BUILD)/%.pc: emulator/testing/%.pc.in FORCE
	$(call renew,sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@LIBDIR@|$(LIBDIR)|' -e 's|@VERSION@|$(VERSION)|' $<)
$(BUILD)/superframe.1: docs/superframe.roff $(BUILD)/superframe
	$(call renew,{ $(BUILD)/superframe manual && cat $<; })

install: $(BUILD)/superframe $(BUILD)/superframe.1 $(COMPLETIONS) $(LIBRARIES) $(PC_FILES) ## Install command, library, test kit and man pages (PREFIX=/usr/local LIBDIR= DESTDIR=)
	@set -e; $(call each_installed,$(INSTALL) -d "$$folder"; $(INSTALL) -m $$mode $$file "$$folder")
	@ln -sf $(SONAME) '$(DESTDIR)$(LIBDIR)/libsuperframe.so'

uninstall: ## Remove what `make install` put there
	@$(call each_installed,rm -f "$$folder/$${file##*/}")
	@rm -f '$(DESTDIR)$(LIBDIR)/libsuperframe.so'
	@rmdir '$(DESTDIR)$(PREFIX)/include/superframe' 2> /dev/null || true

include tests/tests.mk
MAKEFILES_READ := $(MAKEFILE_LIST)

# ---- Goals of one command -----------------------------------------------------------------------

# A row is a goal, its command, what it is for, and in brackets the groups of setup.sh that it takes besides
# `build`. A goal needs the programs that its command names; what scripts need besides stands below.
OUT       = $(BUILD)/out/$(notdir $(basename $(SCENE)))
# image_for TARGET,FILE: the firmware on a target, and from its folder the file to run.
image_for = CC='$(CC)' sh firmware/targets/build.sh $(1) fx $(SCENE) - - minimal $(BUILD)/targets/$@ && cp $(BUILD)/targets/$@/$(2) $(OUT)$(suffix $(2))
DEPTHS ?= 10
ERRORS ?= 4,2,1,0.5
install_if_possible = CC='$(CC)' SETUP='$(SETUP)' sh setup.sh $(1) || true

run:             RUN = $(BUILD)/superframe render $(SCENE) -o $(OUT).png ## Render fig3 (or SCENE=...) to build/out/fig3.png
paper:           RUN = $(BUILD)/superframe paper --jobs 2 -o $(BUILD)/paper ## Make every figure of the paper, and measure its claims, in build/paper [paper]
pc98:            RUN = $(call image_for,386-flat,disk.hdm) ## Make a PC-98 floppy of fig3 (or SCENE=...): build/out/fig3.hdm [pc98]
pc98-probe:      RUN = CC='$(CC)' sh firmware/targets/build_probe.sh $(BUILD)/targets/probe && cp $(BUILD)/targets/probe/disk.hdm $(BUILD)/out/probe.hdm ## Make a PC-98 floppy that asks a real board what is not known: build/out/probe.hdm [pc98]
amalgamation:    RUN = sh emulator/board/amalgamate.sh $(VERSION) $(BUILD)/amalgamation ## Write the board as a part for other emulators: build/amalgamation/superframe_board.[hc]
wasm:            RUN = $(call image_for,wasm,image.wasm) ## Make a WebAssembly module of fig3 (or SCENE=...): build/out/fig3.wasm [quick]
targets:         RUN = sh tests/targets/check_portability.sh && sh tests/targets/table.sh docs/targets.md ## Run fig3 and fig4b on every target; write the table in docs/targets.md [quick targets]
size:            RUN = sh tests/targets/size.sh docs/size.txt ## Measure code, memory, stack and instructions against docs/size.txt [quick targets]
size-keep:       RUN = sh tests/targets/size.sh --keep docs/size.txt ## Keep the figures of `make size` in docs/size.txt [quick targets]
minimal-table:   RUN = sh tests/targets/minimal.sh docs/minimal.md ## Full against minimal images of every scene; write the table in docs/minimal.md [quick]
bench:           RUN = $(call install_if_possible,pov paper); sh tests/bench/bench.sh $(BUILD) $(STAGES) ## Measure what renders cost, alone and against POV-Ray (BENCH=all, STAGES=...)
bench-keep:      RUN = cp $(BUILD)/bench/bench.md docs/ && cp $(wildcard $(addprefix $(BUILD)/bench/,settings.tsv bench.json rays.png ratio.png)) docs/bench/ ## Keep the page, the JSON and the plots of the last `make bench` in docs/
bench-check:     RUN = sh tests/bench/instructions.sh $(BUILD) check docs/bench/instructions.txt ## Hold instructions a ray against docs/bench/instructions.txt (at most 2 % more) [count]
bench-instructions-keep: RUN = sh tests/bench/instructions.sh $(BUILD) keep docs/bench/instructions.txt ## Keep the instructions a ray in docs/bench/instructions.txt [count]
bench-ports:     RUN = $(TOOL)/bench/ports_bench ## Measure what a port write costs, in nanoseconds
usb-table:       RUN = sh tests/bench/usb_bytes.sh $(BUILD)/superframe $(TOOL)/bench/usb_bytes > $(BUILD)/usb-bytes.md && cp $(BUILD)/usb-bytes.md docs/ ## Write docs/usb-bytes.md: what each scene costs on the cable
accuracy:        RUN = $(TOOL)/accuracy/accuracy $(BUILD)/accuracy $(SCENES) ## Whole frames of every built-in scene against f128 (SCENES=... for some)
accuracy-tails:  RUN = $(TOOL)/accuracy/tails $(BUILD)/converged $(or $(CONVERGED_SIZE),640x400) $(SCENES) ## What pruned branches count as: fig3, fig4a, fig5 by arithmetic, threshold and tail (CONVERGED_SIZE=640x400, SCENES=... for some)
accuracy-asked:  RUN = $(TOOL)/accuracy/asked $(BUILD)/converged $(or $(CONVERGED_SIZE),640x400) $(SCENES) ## What --error reaches on every built-in scene, and what it takes (CONVERGED_SIZE=640x400, SCENES=... for some)
accuracy-foreign: RUN = $(TOOL)/accuracy/promise $(or $(FOREIGN_SIZE),80x50) $(DEPTHS) $(ERRORS) $(or $(SCENES),$(wildcard tests/accuracy/foreign/*.scene)) ## Whether --error keeps its promise on scenes that nobody tuned it for (FOREIGN_SIZE=80x50 DEPTHS=10 ERRORS=4,2,1,0.5 SCENES=...)
measure:         RUN = $(BUILD)/superframe measure --size 80x50 --jobs 2 -o $(BUILD)/measure ## Measure speed against accuracy: report and plots in build/measure [paper]
cost-operations: RUN = $(TOOL)/cost/operations ## Count the operations of rays, boundaries and tests
cost-check:      RUN = sh tests/cost/check.sh $(BUILD) docs/measure.md ## Hold the predicted instructions against those that qemu counts; write the table in docs/measure.md [quick]
cost-instructions: RUN = sh tests/cost/instructions.sh $(or $(COST_TARGETS),m0 m3 m4f i386 i387 x86_64) ## Count the instructions of operations (COST_TARGETS="m3 ..."; needs qemu-user, gcc-arm-none-eabi)
fuzz:            RUN = sh tests/check_fuzz.sh $(or $(SECONDS),600) $(FUZZER) ## Fuzz each reader of foreign bytes for SECONDS=600, or FUZZER=scene alone [test]
relations:       RUN = $(RELATIONS) $(BUILD)/relations SEEDS=$(or $(SEEDS),0:300) SECONDS=$(or $(SECONDS),3600) $(RELATION:%=RELATION=%) ## Hold relations on generated scenes (SEEDS=A:B, RELATION=name, SECONDS=limit)
pov:             RUN = $(call install_if_possible,pov); sh tests/pov/check.sh $(BUILD) && sh tests/pov/generated.sh $(BUILD) $(or $(GENERATED),100) ## Hold exported scenes against POV-Ray: pictures and ray counts
adapter:         RUN = sh tests/check_adapter.sh $(ADAPTER_OBJECTS) ## Compile the adapter's device logic for a Cortex-M0+, with its size

GOALS := $(shell sed -n 's/^\([a-z-]*\): *RUN = .*/\1/p' Makefile)
.SECONDEXPANSION:
$(GOALS): $$(filter $(BUILD)/superframe $(TOOLS) $(ADAPTER_OBJECTS),$$(RUN)) | setup
	@mkdir -p $(BUILD)/out
	$(RUN)
pc98 wasm targets size size-keep minimal-table bench bench-check bench-instructions-keep cost-check pov: $(BUILD)/superframe
targets size size-keep minimal-table cost-check cost-instructions: $(BUILD)/targets/count.so
bench: $(filter $(TOOL)/bench/%,$(TOOLS))
cost-check: $(TOOL)/cost/predict
pov: $(TOOL)/pov/pov_check $(RELATIONS)
fuzz: $(FUZZERS)
# Pictures in f128, and converged ones, take minutes: they are kept for as long as the images that made them.
PICTURES_MADE := $(BUILD)/accuracy/made_by $(BUILD)/converged/made_by
accuracy accuracy-tails accuracy-asked: $(PICTURES_MADE)
$(PICTURES_MADE): $(ARITHMETICS:%=$(BUILD)/release/arithmetic_%.o) $(TOOL)/accuracy/frame.o
	@rm -rf $(@D) && mkdir -p $(@D) && touch $@

# ---- The machine --------------------------------------------------------------------------------

# Whatever is compiled waits for it by an order-only prerequisite: it is looked at each time, which
# takes milliseconds, and nothing is rebuilt for it. What goals name in brackets is installed in one go,
# before anything is compiled.
setup: ## Install what the build lacks (SETUP=no only lists it)
	@CC='$(CC)' SETUP='$(SETUP)' sh setup.sh build $(if $(findstring /tests/,$(MAKECMDGOALS)),test) \
	    $(sort $(foreach goal,$(MAKECMDGOALS),$(shell sed -n 's|^$(goal):.* \[\([a-z0-9 ]*\)\]$$|\1|p' $(MAKEFILES_READ))))

clean: ## Remove everything that was built
	rm -rf $(BUILD)

help: ## List the goals, in brackets what setup.sh installs for one besides what the build takes
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/  \1\t\2/p' $(MAKEFILES_READ) | expand -t 27

# Whatever `make help` lists is no file.
.PHONY: $(shell sed -n 's/^\([a-z0-9-]*\):.*## .*/\1/p' $(MAKEFILES_READ)) FORCE run-tests fresh-prefix lint-style lint-cppcheck lint-tidy

-include $(shell find $(addprefix $(BUILD)/,$(CONFIGURATIONS) adapter) -name '*.d' 2>/dev/null)
