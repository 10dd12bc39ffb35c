# SPDX-License-Identifier: MIT
# Speed against accuracy: the measurement itself, and what its predictions are made of; read by
# Makefile.

.PHONY: measure
measure: $(BUILD)/superframe ## Measure speed against accuracy: report and plots in build/measure
	$(BUILD)/superframe measure --size 80x50 --jobs 2 -o $(BUILD)/measure

# An image that counts its operations; it has a written table, and is linked into nothing else.

$(eval $(call image_rules,release,count))

$(BUILD)/release/count_operations: tests/cost/operations.c $(BUILD)/release/image_count.o $(release_HAL) $(release_EMULATOR) $(release_HOST) $(release_STREAMS) $(release_IMAGES) $(release_SCENES) $(BUILD)/sources
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) $(INCLUDE_host) -o $@ $(filter %.c %.o,$^) $(LIBS)

.PHONY: cost-operations
cost-operations: $(BUILD)/release/count_operations ## Count the operations of rays, boundaries and tests
	$(BUILD)/release/count_operations

$(BUILD)/release/predict: tests/cost/predict.c $(release_HAL) $(release_EMULATOR) $(release_HOST) $(release_STREAMS) $(release_IMAGES) $(release_SCENES) $(BUILD)/sources
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) $(INCLUDE_host) -o $@ $(filter %.c %.o,$^) $(LIBS)

.PHONY: cost-check
cost-check: $(BUILD)/superframe $(BUILD)/targets/count.so $(BUILD)/release/predict ## Hold the predicted instructions against those that qemu counts; write the table in docs/measure.md
	sh tests/cost/check.sh $(BUILD) docs/measure.md
SETUP_FOR_cost-check := quick

COST_TARGETS ?= m0 m3 m4f i386 i387 x86_64

.PHONY: cost-instructions
cost-instructions: $(BUILD)/targets/count.so | setup ## Count the instructions of operations (COST_TARGETS="m3 ..."; needs qemu-user, gcc-arm-none-eabi)
	sh tests/cost/instructions.sh $(COST_TARGETS)
