# ballpit_options: what every target of ours is compiled with.
add_library(ballpit_options INTERFACE)
target_include_directories(ballpit_options INTERFACE ${PROJECT_SOURCE_DIR}/src)

if(MSVC)
  # /fp:precise does not contract; Windows headers need NOMINMAX.
  target_compile_options(ballpit_options INTERFACE /W4 /fp:precise /utf-8 $<$<BOOL:${BALLPIT_WERROR}>:/WX>)
  target_compile_definitions(ballpit_options INTERFACE NOMINMAX)
else()
  # No fused multiply-add behind our back: the mirror must round where the shader rounds.
  target_compile_options(ballpit_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wimplicit-fallthrough -ffp-contract=off
    # GCC 12 sees overlaps in std::string's operator+ that are not there (GCC bug 105651).
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    $<$<BOOL:${BALLPIT_WERROR}>:-Werror>)
endif()

if(BALLPIT_SANITIZE)
  target_compile_options(ballpit_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                   -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS
    # gcc warns of memory that only the sanitizers' own code leaves unset, even inside <regex>.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(ballpit_options INTERFACE -fsanitize=address,undefined)
endif()
if(BALLPIT_SANITIZE_THREADS)
  target_compile_options(ballpit_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(ballpit_options INTERFACE -fsanitize=thread)
endif()
if(BALLPIT_STATIC_RUNTIME)
  target_link_options(ballpit_options INTERFACE -static-libstdc++ -static-libgcc)
endif()
