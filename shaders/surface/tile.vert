// The vertex stage of paths that draw tiles as vertices: patches or points.
#version 460

layout(location = 0) flat out uint outTile;

void main()
{
    outTile = gl_VertexIndex;
}
