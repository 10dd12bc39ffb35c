/* SPDX-License-Identifier: MIT */
/* Paths of files: joined, followed through links, and resolved so that they can be compared. */
#ifndef SUPERFRAME_FILE_PATH_H
#define SUPERFRAME_FILE_PATH_H

/* The caller frees what these return; NULL with errno set on failure. */

/* "folder/name". */
char *path_join(const char *folder, const char *name);

/* A name in the folder that a path lies in: "a/b" and "c" make "a/c". A name that starts from the
 * root stays as it is. */
char *path_beside(const char *path, const char *name);

/* Where symbolic links lead, be it there already or not. */
char *path_follow_links(const char *path);

/* The path from the root without links, "." and "..": two spellings of a file are the same, also
 * where it, or the folder that it is in, is not there yet. */
char *path_resolve(const char *path);

#endif
