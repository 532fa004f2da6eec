# What the system has no package of is downloaded where BALLPIT_FETCH_MISSING says so, and refused in one sentence
# elsewhere: nobody's build goes to the network unasked.
include(FetchContent)

# Leaves the sources in <name>_SOURCE_DIR. The tag is fixed: a build next year is the build of today.
function(ballpit_fetch name repository tag)
  if(NOT BALLPIT_FETCH_MISSING)
    message(FATAL_ERROR "${name} is not installed; install its development package (docs/building.md), or configure "
                        "with -DBALLPIT_FETCH_MISSING=ON to download it")
  endif()
  message(STATUS "Fetching ${name} ${tag}")
  # A folder that does not exist keeps CMake from running the project's own build: only its sources are wanted.
  FetchContent_Declare(${name} GIT_REPOSITORY ${repository} GIT_TAG ${tag} SOURCE_SUBDIR sources-only)
  FetchContent_MakeAvailable(${name})
  set(${name}_SOURCE_DIR ${${name}_SOURCE_DIR} PARENT_SCOPE)
endfunction()

# Installs glad 2 into a Python environment in the build folder and sets GLAD_GENERATOR.
function(ballpit_fetch_glad)
  if(NOT BALLPIT_FETCH_MISSING)
    message(FATAL_ERROR "the glad 2 generator is not installed; install it (python3-glad, or pip install glad2), or "
                        "configure with -DBALLPIT_FETCH_MISSING=ON to download it")
  endif()
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(environment ${PROJECT_BINARY_DIR}/python)
  execute_process(COMMAND ${Python3_EXECUTABLE} -m venv ${environment} COMMAND_ERROR_IS_FATAL ANY)
  find_program(environment_python python PATHS ${environment}/bin ${environment}/Scripts NO_DEFAULT_PATH REQUIRED)
  execute_process(COMMAND ${environment_python} -m pip install --quiet glad2==2.0.8 COMMAND_ERROR_IS_FATAL ANY)
  find_program(GLAD_GENERATOR glad PATHS ${environment}/bin ${environment}/Scripts NO_DEFAULT_PATH REQUIRED)
endfunction()
