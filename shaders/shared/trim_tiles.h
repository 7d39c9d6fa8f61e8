// Parts of a picture in which borders of trimmed surfaces are looked for, and the list of the pixels where they are smoothed.
#ifndef KNOTSPAN_TRIM_TILES_H
#define KNOTSPAN_TRIM_TILES_H

#define TRIM_TILE_WIDTH 32  // pixels
#define TRIM_TILE_HEIGHT 128
#define TRIM_TILE_THREADS 64
#define TRIM_LIST_HEAD 4  // words before a list's pixels
#define TRIM_LIST_THREADS 64
#define TRIM_LIST_GROUPS 65535  // no more at once; threads take several pixels

#endif
