// Parts of a picture in which borders of trimmed surfaces are looked for and smoothed.
#ifndef KNOTSPAN_TRIM_TILES_H
#define KNOTSPAN_TRIM_TILES_H

#define TRIM_TILE 32  // pixels on a side
#define TRIM_TILE_THREADS 64

#endif
