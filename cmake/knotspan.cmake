# What all targets share: the language, the warnings, the include root; and the two functions that make targets.

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    # Precompiled headers need these two to be cached.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} ${CCACHE_PROGRAM})
endif()

add_library(knotspan_common INTERFACE)
target_compile_features(knotspan_common INTERFACE cxx_std_20)
target_include_directories(knotspan_common INTERFACE "${CMAKE_SOURCE_DIR}")
target_compile_options(knotspan_common INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
    # Naming the first member only is how Vulkan's structures are meant to be made.
    -Wno-missing-field-initializers
    # g++ 12 sees overlaps and overflows in std::string that are not there (its bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
    $<$<BOOL:${KNOTSPAN_WERROR}>:-Werror>
    # Contraction would make the same formula give other bits in other places.
    -ffp-contract=off)
target_compile_definitions(knotspan_common INTERFACE QT_NO_KEYWORDS GLM_FORCE_XYZW_ONLY
    # A GLM that is newer than ours warns about nothing; an older one must not change its defaults.
    GLM_FORCE_DEPTH_ZERO_TO_ONE)
if(KNOTSPAN_SANITIZE)
    target_compile_options(knotspan_common INTERFACE -fsanitize=${KNOTSPAN_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(knotspan_common INTERFACE -fsanitize=${KNOTSPAN_SANITIZE})
endif()

# A folder's library: knotspan_library(NAME SOURCES a.cpp … USES public targets … PRIVATE targets … PCH <header> …).
# USES are the targets whose headers this folder's headers include; PRIVATE ones stay inside.
function(knotspan_library name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;USES;PRIVATE;PCH")
    add_library(${name} STATIC ${arg_SOURCES})
    target_link_libraries(${name} PUBLIC knotspan_common ${arg_USES} PRIVATE ${arg_PRIVATE})
    if(arg_PCH)
        target_precompile_headers(${name} PRIVATE ${arg_PCH})
    endif()
endfunction()

# A test program, which CTest runs as one test: knotspan_test(NAME SOURCES … USES … [QT] [LABELS …]).
function(knotspan_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT" "SOURCES;USES;LABELS;ENVIRONMENT")
    add_executable(${name} ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE knotspan_common knotspan_test_support ${arg_USES})
    target_precompile_headers(${name} REUSE_FROM knotspan_test_support)
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 300)
    endif()
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}"
        ENVIRONMENT "${arg_ENVIRONMENT}")
endfunction()
