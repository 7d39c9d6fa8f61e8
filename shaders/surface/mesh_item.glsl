// Which tile a vertex or a triangle of the path compute belongs to: the first whose part ends behind it.
uint tileOfItem(uint item, bool triangles)
{
    uint low = 0u;
    uint high = heldTiles() - 1u;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if ((triangles ? ends[middle].y : ends[middle].x) > item)
            high = middle;
        else
            low = middle + 1u;
    }
    return low;
}
