// What the task stage hands to its mesh groups: the KSQuads to draw, one a group.
struct MeshPayload {
    uint ksquads[TASK_KSQUADS];
};
