# Set-up shared by scripts/run and scripts/test: sourced by them, run from the repository's root.

# pip_install leaves bytecode to the first import. Where this variable forbids to write it, as on some machines that only
# run tests, each of the many processes that the tests start would translate every module that it imports anew.
unset PYTHONDONTWRITEBYTECODE

say() {
    printf '\n==> %s\n' "$*" >&2
}

fail() {
    printf '\nerror: %s\n' "$*" >&2
    exit 1
}

# step WHAT COMMAND...: runs the command and says in one line what it does and how long it took. What the command prints
# is shown only where it fails.
step() {
    local what=$1 log start=$SECONDS
    shift
    mkdir -p build
    log=$(mktemp build/step.XXXXXX)
    [ ! -t 2 ] || printf '%s ...' "$what" >&2
    ("$@") >"$log" 2>&1 </dev/null || {
        printf '\n' >&2
        cat "$log" >&2
        rm -f "$log"
        printf 'error: this failed, for the reason above: %s\n' "$what" >&2
        return 1
    }
    rm -f "$log"
    [ ! -t 2 ] || printf '\r' >&2
    printf '%-76s %5d s\n' "$what" $((SECONDS - start)) >&2
}

# may_use_sudo WHAT...: asks on a terminal. Without a terminal the answer is no.
may_use_sudo() {
    local answer
    command -v sudo >/dev/null && [ -t 0 ] && [ -t 2 ] || return 1
    printf '\nMissing: %s. Install by sudo apt-get? [y/N] ' "$*" >&2
    read -r answer || return 1
    [[ $answer == [yY]* ]]
}

# install_packages PACKAGE...: by apt-get, with sudo only after asking. Where neither is possible, says what is missing.
install_packages() {
    local as_root=()
    command -v apt-get >/dev/null ||
        fail "missing: $*. Install what your system calls them; documentation/install.md names them"
    if [ "$(id -u)" -ne 0 ]; then
        may_use_sudo "$@" || fail "please install, as root:  apt-get install $*"
        as_root=(sudo)
    fi
    step "Package lists of apt-get" "${as_root[@]}" apt-get update -qq &&
        step "By apt-get: $*" "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "$@"
}

# need_debian_packages PACKAGE...: installs the packages that dpkg does not list as installed. Systems without dpkg are left
# alone: there cmake and python say what they lack.
need_debian_packages() {
    local missing=() package
    command -v dpkg-query >/dev/null || return 0
    for package in "$@"; do
        dpkg-query --show --showformat='${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] || install_packages "${missing[@]}"
}

can_compile() {
    printf '#include <stdio.h>\nint main(void) { return 0; }\n' | cc -x c -o /dev/null - 2>/dev/null
}

# need_build_tools: a C compiler with its headers, CMake and Ninja, wherever they come from.
need_build_tools() {
    local missing=()
    can_compile || missing+=(gcc libc6-dev)
    command -v cmake >/dev/null || missing+=(cmake)
    command -v ninja >/dev/null || missing+=(ninja-build)
    [ ${#missing[@]} -eq 0 ] || install_packages "${missing[@]}"
}

# SUNDIALS, for the second solver of Co-Simulation. Installing its development package would bring some 160 others
# (MPI, PETSc); of these only its own headers and static libraries are needed, so it is unpacked, not installed.
unpack_sundials() {
    mkdir -p "$1"
    cd "$1" || return
    apt-get download -qq libsundials-dev || { apt-get update -qq && apt-get download -qq libsundials-dev; } || return 0
    dpkg -x libsundials-dev_*.deb .
}

get_sundials() {
    local folder=$PWD/build/sundials
    [ -e /usr/include/cvode/cvode.h ] && return 0
    if [ ! -e "$folder/usr/include/cvode/cvode.h" ] && command -v apt-get >/dev/null; then
        step "SUNDIALS (Debian's libsundials-dev), unpacked into build/sundials" unpack_sundials "$folder"
        [ -e "$folder/usr/include/cvode/cvode.h" ] || say "SUNDIALS could not be fetched: the unit is built without CVODE"
    fi
    export CVODE_ROOT=$folder/usr
}

# The package, the C tests, the source distribution and the installed library compile the core with the same flags, in
# folders of the same depth: with ccache they do so once. ccache knows a file by its compiler and all flags, with paths
# relative to the build folder, and without the locale, which the test of the source distribution does not hand on.
share_compilations() {
    command -v ccache >/dev/null || need_debian_packages ccache
    command -v ccache >/dev/null || return 0
    export CMAKE_C_COMPILER_LAUNCHER=ccache CCACHE_DIR=${CCACHE_DIR:-$PWD/build/ccache} CCACHE_BASEDIR=/
    export CCACHE_SLOPPINESS=locale CC=${CC:-gcc} CMAKE_GENERATOR=Ninja
    export SKBUILD_CMAKE_DEFINE=TDMF_SLIP_WARNINGS_ARE_ERRORS=ON
}

# Python 3.11 or later with the module venv, which Debian keeps in a package of its own.
need_python() {
    command -v python3 >/dev/null || install_packages python3 python3-venv
    python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' || fail "Python 3.11 or later is needed, python3 is $(python3 --version)"
    python3 -c 'import ensurepip, venv' 2>/dev/null || need_debian_packages python3-venv
}

# pip_install ARGUMENT...: into .venv, without compiling to bytecode: most modules are never imported.
pip_install() {
    .venv/bin/python -m pip install --quiet --disable-pip-version-check --no-input --no-compile "$@"
}

# install_locked NAME [OPTION...]: exactly the Python packages of scripts/locks/NAME.txt, by their hashes; scripts/lock
# makes these files.
install_locked() {
    local name=$1
    shift
    pip_install --require-hashes "$@" -r "scripts/locks/$name.txt"
}

# install_once NAME: installs the lock NAME unless it is installed already.
install_once() {
    local wanted stamp=.venv/installed.$1
    wanted=$(cksum "scripts/locks/$1.txt")
    if [ "$(cat "$stamp" 2>/dev/null)" != "$wanted" ]; then
        step "Python packages of scripts/locks/$1.txt" install_locked "$1" || return
        printf '%s\n' "$wanted" >"$stamp"
    fi
}

make_empty_environment() {
    need_python
    .venv/bin/python -c 'import pip' 2>/dev/null ||
        step "Python's virtual environment in .venv" python3 -m venv --clear .venv
}

# make_environment [NAME]: the virtual environment .venv, with the package, what it needs, and what the lock NAME adds.
# Building without isolation lets the C build go on where it stopped.
make_environment() {
    make_empty_environment
    local name
    for name in environment "$@"; do
        install_once "$name"
    done
    step "C library, units and Python package, built and installed into .venv" \
        pip_install --no-build-isolation --no-deps --force-reinstall .
}

# The compiler of the live page, and of all that is made for other platforms.
get_zig() {
    install_once zig
}

# Zig, and what reads, packs and checks its results.
get_release_tools() {
    get_zig && install_once platforms
}

# Files of a release carry the time of the last commit, so that the same sources make the same bytes.
set_source_date() {
    SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 315532800)}
    export SOURCE_DATE_EPOCH
}

PLATFORMS=(x86_64-linux aarch64-linux x86_64-windows aarch64-windows x86_64-darwin aarch64-darwin)

# for_each_platform COMMAND WHAT: COMMAND PLATFORM for every one, two side by side, for Zig uses one processor only.
for_each_platform() {
    local command=$1 what=$2 first platform pair processes
    for ((first = 0; first < ${#PLATFORMS[@]}; first += 2)); do
        pair=("${PLATFORMS[@]:first:2}")
        processes=()
        for platform in "${pair[@]}"; do
            "$command" "$platform" >"build/platforms/$what.$platform.log" 2>&1 &
            processes+=($!)
        done
        for platform in "${pair[@]}"; do
            wait "${processes[0]}" || {
                tail -n 40 "build/platforms/$what.$platform.log" >&2
                fail "the $what for $platform could not be built"
            }
            processes=("${processes[@]:1}")
        done
    done
}

# build_platform PLATFORM: its units, the importer that compares platforms, and the library of its wheel, in one build.
build_platform() {
    cmake --preset "$1" -DPython3_EXECUTABLE="$PWD/.venv/bin/python" &&
        cmake --build "build/platforms/$1" --target tdmf_slip_python_package importer
}

# Everything for every platform, in build/platforms: each cross-compiled by Zig, then the units of all in one file.
build_platforms() {
    local platform units=()
    mkdir -p build/platforms
    set_source_date
    say "Cross-compiling by Zig: ${PLATFORMS[*]}"
    for_each_platform build_platform binaries
    for platform in "${PLATFORMS[@]}"; do
        units+=("build/platforms/$platform/fmu_src")
    done
    .venv/bin/python scripts/merge_fmus.py build/platforms "${units[@]}"
}

# wheel_tag PLATFORM: the tag of its wheel, which names the oldest system that Zig builds for.
wheel_tag() {
    case $1 in
    x86_64-linux) echo manylinux_2_17_x86_64 ;;
    aarch64-linux) echo manylinux_2_17_aarch64 ;;
    x86_64-windows) echo win_amd64 ;;
    aarch64-windows) echo win_arm64 ;;
    x86_64-darwin) echo macosx_11_0_x86_64 ;;
    aarch64-darwin) echo macosx_11_0_arm64 ;;
    *) fail "no wheel tag is known for the platform $1" ;;
    esac
}

# Into dist, of what build_platforms has built: a wheel of the Python files alone, and for each platform its library and
# headers beside them, and the units of all platforms.
pack_wheels() {
    local platform folder=build/platforms/wheels packed=()
    rm -rf "$folder"
    .venv/bin/python -m build --wheel --no-isolation -C wheel.cmake=false -o "$folder/pure" . || return
    for platform in "${PLATFORMS[@]}"; do
        cmake --install "build/platforms/$platform" --component unit --prefix "$folder/$platform" &&
            cp build/platforms/TDMF_SLIP.fmu build/platforms/TDMF_SLIP_FMI3.fmu "$folder/$platform/tdmf_slip" || return
        packed+=("$(wheel_tag "$platform")=$folder/$platform")
    done
    .venv/bin/python scripts/pack_wheels.py "$folder"/pure/*.whl dist "${packed[@]}"
}

# The release in dist: source distribution, a wheel for every platform, both units, and the files that
# scripts/release_files.py writes.
build_distribution() {
    set_source_date
    say "Packing source distribution and wheels into dist"
    mkdir -p dist
    rm -f dist/*.whl dist/*.tar.gz dist/*.fmu dist/*.cdx.json dist/RELEASE_NOTES.md dist/recipe.yaml dist/SHA256SUMS
    { .venv/bin/python -m build --sdist --no-isolation -o dist . && pack_wheels; } >build/distribution.log 2>&1 || {
        tail -n 40 build/distribution.log >&2
        fail "the distribution could not be made"
    }
    cp build/platforms/TDMF_SLIP.fmu build/platforms/TDMF_SLIP_FMI3.fmu dist
    .venv/bin/python scripts/release_files.py dist
}

get_site_tools() {
    need_debian_packages graphviz
    install_once site
}

# The site, in dist/site, with warnings as errors, and the live page in it. The gallery is drawn, and the live page compiled,
# while Sphinx writes the pages: Zig uses one processor only.
build_site() {
    get_site_tools
    get_zig
    say "Building the site into dist/site"
    rm -rf dist/site build/site
    mkdir -p build/site/live dist
    local drawing compiling
    .venv/bin/tdmf-slip figures --format png --output build/site/figures >build/site/gallery.log 2>&1 &
    drawing=$!
    documentation/live/build build/site/live >build/site/live.log 2>&1 &
    compiling=$!
    .venv/bin/python -m sphinx --builder html --fail-on-warning --keep-going --quiet --jobs 2 \
        --doctree-dir build/site/read documentation build/site/html >build/site/log 2>&1 || {
        cat build/site/log >&2
        kill "$drawing" "$compiling" 2>/dev/null || true
        fail "the site could not be built"
    }
    wait "$drawing" || {
        tail -n 20 build/site/gallery.log >&2
        kill "$compiling" 2>/dev/null || true
        fail "the gallery's figures could not be drawn"
    }
    wait "$compiling" || {
        cat build/site/live.log >&2
        fail "the live page could not be built"
    }
    mv build/site/html dist/site
    mv build/site/figures build/site/live/* dist/site
}

# Wine's copy of Windows, made at its first start in some seconds, or in a minute on a busy machine.
make_windows_folder() {
    local wine folder=$PWD/build/platforms/wine
    wine=$(PATH=$PATH:/usr/lib/wine command -v wine64) || return 0
    [ -e "$folder/system.reg" ] && return 0
    say "Making wine's folder of Windows in build/platforms/wine"
    mkdir -p "$folder"
    WINEPREFIX=$folder WINEDEBUG=-all "$wine" wineboot --init >build/wine.log 2>&1 ||
        say "wine's folder could not be made: see build/wine.log"
}

# Tools for the tests of platforms and distribution: wine64 for Windows, qemu-user for Arm Linux, and Zig, which builds what
# is tested. If a tool cannot be installed, a message says so and its tests are skipped.
get_platform_tools() {
    (need_debian_packages wine64 qemu-user libc6-arm64-cross) ||
        say "NOT TESTED: Windows and Arm Linux, because wine64 or qemu-user could not be installed"
    get_release_tools ||
        { say "NOT TESTED: other platforms and the distribution, because Zig could not be installed"; return 1; }
}

# Builds what the tests of platforms and distribution look at.
prepare_release() {
    make_windows_folder
    build_platforms
    build_distribution
}

# Importers that take minutes to install: FMI4j and VDMCheck from Maven Central, fmi-sim from crates.io.
get_importers() {
    local place=$PWD/build/importers python=.venv/bin/python
    need_debian_packages default-jdk-headless maven
    say "Fetching FMI4j and VDMCheck"
    mvn --quiet --batch-mode -f tests/importers/pom.xml dependency:copy-dependencies -Dmdep.stripVersion=true \
        -DoutputDirectory="$place/java"
    # VDMCheck reads its rules and schemas as files beside its jars.
    local jar
    for jar in static-model rule-model vdmcheck2; do
        "$python" -m zipfile -e "$place/java/$jar.jar" "$place/java"
    done
    if [ -x "$place/bin/fmi-sim" ]; then
        return
    fi
    if ! command -v cargo >/dev/null; then
        say "NOT TESTED: fmi-sim, because cargo (Rust 1.85 or newer, see rustup.rs) is missing"
        return
    fi
    say "Building fmi-sim; this takes some minutes"
    install_locked fmi_sim --target "$place/libclang"
    LIBCLANG_PATH=$place/libclang/clang/native BINDGEN_EXTRA_CLANG_ARGS=-I$(gcc -print-file-name=include) \
        CARGO_TARGET_DIR=$place/cargo cargo install --quiet --locked --root "$place" --version 0.7.0 fmi-sim
}
