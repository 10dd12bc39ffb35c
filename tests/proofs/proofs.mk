# SPDX-License-Identifier: MIT
# What is proved of fixed point, for all arguments, and of the adapter; read by Makefile.

# Every PROOF_STEP-th argument is tried (a power of two to 65536): 1 is a proof, more is a sample.
PROOF_STEP ?= 1
PROOF_CC   := $(CC) $(WARNINGS) -O3 -Ifirmware/real/fx -Ihal -Ifirmware

# Undefined behaviour in root and reciprocal, which Eva takes as given, ends the trial.
$(BUILD)/proofs/root_exhaustive: tests/real/root_exhaustive.c $(wildcard firmware/real/fixed*.h) | setup
	@mkdir -p $(@D)
	$(PROOF_CC) -fsanitize=undefined -fno-sanitize-recover=all -o $@ $< -lpthread

$(BUILD)/proofs/exponential_exhaustive: tests/proofs/exponential_exhaustive.c $(wildcard firmware/real/fixed*.h) | setup
	@mkdir -p $(@D)
	$(PROOF_CC) -idirafter $(COMPILER_HEADERS) -o $@ $< -lquadmath -lpthread

.PHONY: prove
prove: $(BUILD)/proofs/root_exhaustive $(BUILD)/proofs/exponential_exhaustive ## Prove ranges and errors of fixed point (Frama-C, Gappa, exhaustive trial), and the adapter's answers
	sh tests/proofs/ranges.sh $(BUILD)/proofs/ranges
	sh tests/proofs/bounds.sh
	sh tests/proofs/usb_requests.sh $(BUILD)/proofs
	timeout -k 5 600 $(BUILD)/proofs/exponential_exhaustive 2 $(PROOF_STEP)
	timeout -k 5 900 $(BUILD)/proofs/root_exhaustive 2 $(PROOF_STEP)

SETUP_FOR_prove := prove
