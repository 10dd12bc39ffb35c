/* SPDX-License-Identifier: MIT */
/* Paths of files: joined, followed through links, and resolved so that they can be compared. */
#ifndef SUPERFRAME_FILE_PATH_H
#define SUPERFRAME_FILE_PATH_H

/* The caller frees what these functions return; NULL with errno set on failure. */

/* Joins the two to "folder/name". */
char *path_join(const char *folder, const char *name);

/* Puts a name into the folder that a path lies in: "a/b" and "c" make "a/c". A name that starts
 * from the root stays as it is. */
char *path_beside(const char *path, const char *name);

/* Returns where symbolic links lead, be that place there already or not. */
char *path_follow_links(const char *path);

/* Returns the path from the root without links, "." and "..", so that two spellings of a file
 * become the same. The file, or the folder that the file is in, need not be there yet. A ".." after
 * a folder that is not there stays. */
char *path_resolve(const char *path);

#endif
