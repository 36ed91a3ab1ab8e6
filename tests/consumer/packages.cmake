# SPDX-License-Identifier: MIT
# packages.cmake with SOURCE, BUILD, SCRATCH, COMPILER, GENERATOR: makes both Debian packages by cpack, checks their
# fields, unpacks them next to each other, and uses their content: README's example by find_package and by pkg-config, and the
# program. If lintian is installed, it checks the packages; the tags that it may print are listed here, each with a reason.
cmake_minimum_required(VERSION 3.25)
set(ENV{CXXFLAGS} "")
set(ENV{LDFLAGS} "")
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(allowed_tags
    bogus-mail-host                      # there is no mailing list
    bogus-mail-host-in-debian-changelog  # there is no mailing list
    pkg-config-unavailable-for-cross-compilation  # lib, not lib/TRIPLE: the package is for its own machine
    initial-upload-closes-no-bugs        # not Debian's own package
    extra-license-file                   # the library's LICENSE, for users who copy the headers
    hardening-no-fortify-functions)      # the measured code is compiled as users compile it

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH}/unpacked)
find_program(CPACK cpack REQUIRED)
run("cpack" ${CPACK} --config ${BUILD}/CPackConfig.cmake -B ${SCRATCH}/made -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip)
file(GLOB packages ${SCRATCH}/made/*.deb)
list(LENGTH packages count)
if(NOT count EQUAL 2)
    message(FATAL_ERROR "cpack made ${count} packages, not 2: ${packages}")
endif()

# expect_field(PACKAGE FIELD REGEX)
function(expect_field PACKAGE FIELD WANTED)
    run("dpkg-deb" dpkg-deb -f ${PACKAGE} ${FIELD})
    if(NOT output MATCHES "${WANTED}")
        message(SEND_ERROR "${PACKAGE}: ${FIELD} is '${output}', not ${WANTED}")
    endif()
endfunction()

foreach(package IN LISTS packages)
    run("unpacking" dpkg-deb -x ${package} ${SCRATCH}/unpacked)
    if(package MATCHES "libedgewise-dev")
        expect_field(${package} Depends "libeigen3-dev.*libqhull-dev")
        expect_field(${package} Section "libdevel")
    else()
        expect_field(${package} Depends "libc6.*libstdc[+][+]6")  # found by dpkg-shlibdeps
        expect_field(${package} Package "^edgewise\n")
    endif()
endforeach()
set(prefix ${SCRATCH}/unpacked/usr)
foreach(file bin/edgewise share/man/man1/edgewise.1.gz share/bash-completion/completions/edgewise
        share/zsh/site-functions/_edgewise share/fish/vendor_completions.d/edgewise.fish share/doc/edgewise/copyright share/doc/libedgewise-dev/changelog.gz)
    if(NOT EXISTS ${prefix}/${file})
        message(SEND_ERROR "no /usr/${file} in the packages")
    endif()
endforeach()

read_example(${SOURCE}/README.md example expected)
file(WRITE ${SCRATCH}/example.cpp "${example}")
run("configuring" ${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer/project -B ${SCRATCH}/build -G ${GENERATOR}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${prefix}
    -D EXAMPLE=${SCRATCH}/example.cpp)
run("building" ${CMAKE_COMMAND} --build ${SCRATCH}/build --target consumer)
expect_output("README's example by find_package" ${SCRATCH}/build/consumer "${expected}")

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
    file(GLOB_RECURSE description ${prefix}/*/edgewise.pc)
    get_filename_component(folder ${description} DIRECTORY)
    set(ENV{PKG_CONFIG_PATH} ${folder})
    run("pkg-config" ${PKG_CONFIG} --define-prefix --cflags --libs edgewise)
    string(STRIP "${output}" flags)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    run("compiling by pkg-config" ${COMPILER} -O2 ${SCRATCH}/example.cpp ${flags} -o ${SCRATCH}/by_pkg_config)
    expect_output("README's example by pkg-config" ${SCRATCH}/by_pkg_config "${expected}")
else()
    message("no pkg-config here: edgewise.pc is not tried")
endif()

run("the packaged program" ${prefix}/bin/edgewise list layouts --json)
if(NOT output MATCHES "\"name\":\"aos\"")
    message(SEND_ERROR "the packaged program lists no layouts:\n${output}")
endif()
message("the packaged program lists its layouts")

find_program(LINTIAN lintian)
if(LINTIAN)
    list(JOIN allowed_tags "," tags)
    run("lintian" ${LINTIAN} --allow-root --fail-on error,warning --suppress-tags ${tags} ${packages})
    message("lintian: nothing but the tags that are allowed\n${output}")
else()
    message("no lintian here: the packages are not looked at by it (Debian: lintian)")
endif()
