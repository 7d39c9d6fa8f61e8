// What the task stage of the path mesh hands to its mesh groups: group g draws the tiles from start g to start g + 1,
// counted from firstTile.
struct TilePayload {
    uint firstTile;
    uint starts[TILE_PAYLOAD_WORDS];  // a byte each
};
