// The commands of the program. Each adds its own options to the command line and sets `exitCode` when it ran.
//
// Exit codes are a contract: 0 done, 1 the work failed (one sentence on standard error), 2 the call was wrong
// (a CLI::ParseError, which main() reports), 3 the model, or a mesh that was made of it,
// misses a tolerance. Data goes to standard output,
// everything else to standard error.
#pragma once

#include <CLI/CLI.hpp>

namespace knotspan::app {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongCall = 2;
constexpr int kToleranceMissed = 3;

void addRenderCommand(CLI::App& app, int& exitCode);
void addConvertCommand(CLI::App& app, int& exitCode);
void addInfoCommand(CLI::App& app, int& exitCode);
void addAnalyzeCommand(CLI::App& app, int& exitCode);
void addCompareCommand(CLI::App& app, int& exitCode);
void addSampleCommand(CLI::App& app, int& exitCode);
void addEvaluateCommand(CLI::App& app, int& exitCode);
void addMeasureCommand(CLI::App& app, int& exitCode);

// Not in the help: the program starts itself with it, to read files that may crash or hang their reader.
void addImportWorkerCommand(CLI::App& app);

// `knotspan [FILE...]`, also by the name `window`. Runs where no other command did.
void addWindowCommand(CLI::App& app, int& exitCode, int& argc, char** argv);

}  // namespace knotspan::app
