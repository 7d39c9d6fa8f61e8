// Parts of a picture in which borders of trimmed surfaces are looked for, and the list of the pixels where they are smoothed.
#ifndef KNOTSPAN_TRIM_TILES_H
#define KNOTSPAN_TRIM_TILES_H

#define TRIM_TILE_WIDTH 32  // pixels
#define TRIM_TILE_HEIGHT 128
#define TRIM_TILE_THREADS 64
#define TRIM_LIST_THREADS 64
#define TRIM_LIST_GROUPS 65535  // no more at once; threads take several pixels

// Words before those of pixels: groups along x, y and z that work on the list, how many pixels it has, the first of the
// picture's rows that are looked at together, and how many.
#define TRIM_HEAD 8
#define TRIM_HEAD_COUNT 3
#define TRIM_HEAD_FIRST_ROW 4
#define TRIM_HEAD_ROWS 5
// Rows that a pixel's colour may depend on, above it and below.
#define TRIM_ROWS_BESIDE 4

#endif
