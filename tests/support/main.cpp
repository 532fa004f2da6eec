// Runs the tests that need no OpenGL context.
#include "support/session.h"

int main(int argc, char** argv) { return Catch::Session().run(argc, argv); }
