# SPDX-License-Identifier: MIT
# How right --tail estimate and --error are, against converged pictures; read by Makefile.

CONVERGED_SIZE ?= 640x400

$(BUILD)/release/tests/accuracy/%.o: tests/accuracy/%.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) $(INCLUDE_tests) -MMD -MP -c -o $@ $<

$(BUILD)/release/accuracy_%: $(BUILD)/release/tests/accuracy/%.o $(BUILD)/release/tests/accuracy/frame.o $(release_LIBRARY) $(BUILD)/sources
	$(CC) $(LDFLAGS_release) -o $@ $(filter %.o,$^) $(LIBS)

# Converged pictures take minutes: they are kept for as long as the image that made them.
$(BUILD)/converged/made_by: $(BUILD)/release/image_f64.o $(BUILD)/release/tests/accuracy/frame.o
	@rm -rf $(@D) && mkdir -p $(@D) && touch $@

.PHONY: accuracy-tails accuracy-asked
accuracy-tails: $(BUILD)/release/accuracy_tails $(BUILD)/converged/made_by ## What cut branches count as: fig3, fig4a, fig5 by arithmetic, threshold and tail (CONVERGED_SIZE=640x400, SCENES=... for some)
	$< $(BUILD)/converged $(CONVERGED_SIZE) $(SCENES)

accuracy-asked: $(BUILD)/release/accuracy_asked $(BUILD)/converged/made_by ## What --error reaches on every built-in scene, and what it takes (CONVERGED_SIZE=640x400, SCENES=... for some)
	$< $(BUILD)/converged $(CONVERGED_SIZE) $(SCENES)
