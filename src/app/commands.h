// The commands of the command line that open no window. Each prints its result and gives the exit code.
#pragma once

#include "app/options.h"

namespace ballpit::app {

int open_window(const Options& options);
int run_headless(const Options& options);
int run_check(const Options& options);
int run_bench(const Options& options);
int run_accuracy(const Options& options);
int run_extremes(const Options& options);
int run_scenes();
int run_ledger(const Options& options);
int run_settings();

}  // namespace ballpit::app
