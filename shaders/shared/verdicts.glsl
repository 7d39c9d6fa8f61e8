// What a culling camera that stands still said of each KSQuad: the mode that drops it + 1, or 0. Noted by frames drawn from
// there (FRAME_NOTE_VERDICTS), read by those that an eye elsewhere sees (FRAME_KEEP_VERDICTS).
#ifndef KNOTSPAN_VERDICTS_GLSL
#define KNOTSPAN_VERDICTS_GLSL

#include "scene.glsl"

#ifndef KNOTSPAN_VERDICT_ACCESS
#define KNOTSPAN_VERDICT_ACCESS readonly
#endif
layout(set = 0, binding = BINDING_VERDICTS, scalar) KNOTSPAN_VERDICT_ACCESS buffer VerdictBuffer { uint verdicts[]; };

bool keepsVerdicts() { return (frame.flags & FRAME_KEEP_VERDICTS) != 0u; }
bool notesVerdicts() { return (frame.flags & FRAME_NOTE_VERDICTS) != 0u; }

#endif
