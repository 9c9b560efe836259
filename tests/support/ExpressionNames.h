#pragma once

/// The six expressions that have bundled tables.
inline const char* const expressionNames[] = {"anger", "disgust", "fear", "joy", "sadness", "surprise"};
