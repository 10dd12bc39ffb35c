/* SPDX-License-Identifier: MIT */
/* The SuperFrame board in NP2kai. docs/emulators.md says where each function is called. */
#ifndef SUPERFRAME_NP2_H
#define SUPERFRAME_NP2_H

/* After compiler.h, pccore.h, iocore.h, scrnmng.h and statsave.h, as everywhere in NP2kai. */

/* For resetfn[] and bindfn[] of iocore.c. */
void superframe_np2_reset(const NP2CFG *config);
void superframe_np2_bind(void);

/* For iocore_out16() and iocore_inp16(), before the table of words. They return FALSE where the
 * access is none of the board's. */
BOOL superframe_np2_out16(UINT port, REG16 value);
BOOL superframe_np2_inp16(UINT port, REG16 *value);

/* For drawscreen(), before pcstat.screenupdate is looked at: has the lines drawn anew that the
 * board has changed. */
void superframe_np2_update(void);

/* For scrndraw_draw(), before the surface is unlocked: draws the board over the lines that were
 * drawn. dirty[y] is not 0 for those. */
void superframe_np2_draw(const SCRNSURF *surface, const UINT8 *dirty);

/* For a STATFLAG of its own in statsave.c. A bad state fails, and says why. */
int superframe_np2_save(STFLAGH state, const SFENTRY *entry);
int superframe_np2_load(STFLAGH state, const SFENTRY *entry);

#endif
