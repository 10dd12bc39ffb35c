# SPDX-License-Identifier: MIT
# What is measured of the tests and of ports: speed, coverage, mutants; read by Makefile.

.PHONY: bench-ports
bench-ports: $(BUILD)/release/ports_bench ## Measure what a port write costs, in nanoseconds
	$(BUILD)/release/ports_bench

$(BUILD)/release/ports_bench: tests/bench/ports_bench.c $(release_HAL) $(release_EMULATOR) $(BUILD)/flags | setup
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) $(INCLUDE_emulator) -o $@ $(filter %.c %.o,$^) -lpng -lxxhash -ldeflate

# Besides the suites, whatever tells by its exit status: release/x,1,2 is build/release/x 1 2.
MUTANT_PROGRAMS ?= tests/check_hashes.sh tests/check_manual.sh $(RELATIONS:$(BUILD)/%=%),build/relations,SEEDS=0:60
.PHONY: mutants
mutants: | setup ## Break the source in small ways and see whether the tests notice (SEED= COUNT= SECONDS= FILES=)
	@SEED='$(SEED)' FIRST='$(FIRST)' COUNT='$(COUNT)' LIMIT='$(SECONDS)' FILES='$(FILES)' SANITIZED='$(SANITIZED)' CC='$(CC)' \
	    sh tests/mutants/run.sh $(BUILD) $(MUTANT_PROGRAMS) $(patsubst $(BUILD)/%,%,$(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(USB_TEST_PROGRAMS))

# The suites of hal/ and emulator/, linked with those two built once more, their branches counted. What
# the processor's own ports need is no test's to run: hal/ports_linux.c.
COVERED_SUITES := bus cost_bus fault_bus ports_linux board board_control board_report board_table driver_run native_screen picture png_file trace trace_damage trace_text trace_tools trace_hash testkit trace_command adapter_command $(patsubst tests/%_test.c,%,$(wildcard tests/usb_*_test.c tests/pc98_*_test.c))
COVERED_OBJECTS := $(HAL_SOURCES:%.c=$(BUILD)/coverage/%.o) $(EMULATOR_SOURCES:%.c=$(BUILD)/coverage/%.o)
COVERED_BESIDES := $(release_HOST) $(release_STREAMS) $(release_IMAGES) $(release_SCENES)
GCOVR := gcovr --root . --object-directory $(BUILD)/coverage --exclude-unreachable-branches --branches $(BUILD)/coverage

$(BUILD)/coverage/%.o: %.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) -O0 -g --coverage $(INCLUDE_testkit) -MMD -MP -c -o $@ $<

$(BUILD)/coverage/superframe: $(BUILD)/release/host/main.o $(COVERED_OBJECTS) $(COVERED_BESIDES)
	$(CC) -o $@ $^ --coverage $(LIBS)

$(BUILD)/coverage/%_test: tests/%_test.c $(COVERED_OBJECTS) $(TESTKIT_SOURCES) $(COVERED_BESIDES)
	$(CC) $(WARNINGS) $(POSIX) -O0 -g $(INCLUDE_tests) -Iemulator/testing -o $@ $(filter %.c %.o,$^) --coverage -lcmocka $(LIBS)

.PHONY: coverage
coverage: $(COVERED_SUITES:%=$(BUILD)/coverage/%_test) $(BUILD)/coverage/superframe ## Measure the branches of hal/ and emulator/ that the suites take (100 % and 95 %)
	@find $(BUILD)/coverage -name '*.gcda' -delete
	@for suite in $(COVERED_SUITES); do BUILD=$(BUILD) SUPERFRAME=$(BUILD)/coverage/superframe timeout 300 $(BUILD)/coverage/$${suite}_test > $(BUILD)/coverage/$$suite.log 2>&1 || { tail -n 40 $(BUILD)/coverage/$$suite.log; exit 1; }; done
	$(GCOVR) --filter 'hal/usb/'
	$(GCOVR) --filter 'hal/[^/]*$$' --exclude 'hal/ports_linux.c' --fail-under-branch 100
	$(GCOVR) --filter 'emulator/[^/]*$$' --fail-under-branch 95

-include $(COVERED_OBJECTS:.o=.d)
