#!/usr/bin/env bash
# Two commands for a fresh Debian 12 machine: `./run.sh demo` and `./run.sh test`; `./run.sh help` says more.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$root/build/release

demo_packages=(
	g++ cmake ninja-build ccache
	libmrpt-nav-dev libeigen3-dev liboctomap-dev zlib1g-dev
	libcli11-dev nlohmann-json3-dev
	libsdformat-dev libassimp-dev libembree-dev
	libopenni2-dev pkg-config
)
# chromium is what the test of report.html looks at it with.
test_packages=("${demo_packages[@]}" libgtest-dev libgmock-dev mrpt-common chromium)
# mrpt-apps has rawlog-edit and rawlog-grabber, which tests of annotated.rawlog and of the grabber's plugin use; without
# it they are skipped.
ci_packages=("${test_packages[@]}" clang-format clang-tidy libbenchmark-dev libmrpt-hwdrivers-dev mrpt-apps
	help2man dpkg-dev file lintian bash-completion doxygen)

usage()
{
	cat <<-END
		usage: ./run.sh demo [argument of explore-mrpt]...
		           installs what is missing, builds, explores the bundled world
		       ./run.sh test [argument of ctest]...
		           the same set-up, then builds and runs every test
		       ./run.sh setup demo|test|ci
		           installs the Debian packages that demo, test or .ci/run need, nothing else
		       ./run.sh help

		The build is in $build. Packages come from the Debian 12 archive, without
		recommended extras; nothing else is downloaded and nothing is written outside of this folder.
	END
}

say() { printf '\n== %s\n' "$*" >&2; }
fail() { printf 'run.sh: %s\n' "$*" >&2; exit 2; }

# timed "what was done" command...: the command's time on stderr once it has succeeded.
timed()
{
	local what=$1 start=$SECONDS
	shift
	"$@" || return
	say "$what in $((SECONDS - start)) s"
}

# Those of the given packages that are not installed, one a line.
missing_packages()
{
	local installed
	installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null |
		sed -n 's/ installed$//p' || true)
	printf '%s\n' "$@" | grep -vxF -e "$installed" || true
}

# Runs a command as root: directly, or through sudo (which asks for a password only where there is a terminal).
as_root()
{
	if [ "$(id -u)" -eq 0 ]; then
		env DEBIAN_FRONTEND=noninteractive "$@"
	elif [ -t 0 ]; then
		sudo env DEBIAN_FRONTEND=noninteractive "$@"
	else
		sudo -n env DEBIAN_FRONTEND=noninteractive "$@"
	fi
}

may_install()
{
	[ "$(id -u)" -eq 0 ] && return 0
	command -v sudo >/dev/null || return 1
	[ -t 0 ] || sudo -n true 2>/dev/null
}

# Package lists that are absent or older than a day make apt ask for files that the mirror no longer has.
lists_are_fresh()
{
	[ -n "$(find /var/lib/apt/lists -maxdepth 1 -name '*Packages*' -mtime -1 -print -quit 2>/dev/null)" ]
}

apt_install()
{
	lists_are_fresh || as_root apt-get update -qq || return
	as_root apt-get install -qq -y --no-install-recommends "$@" >/dev/null </dev/null
}

install_packages()
{
	if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
		fail "this is no Debian system. Install MRPT >= 2.5 (obs, nav, config, system), Eigen 3, OctoMap 1.9, zlib, CLI11," \
			"nlohmann-json and GoogleTest your own way, then: cmake --preset release && cmake --build --preset release"
	fi
	local -a missing
	read -r -d '' -a missing <<<"$(missing_packages "$@")" || true
	[ "${#missing[@]}" -gt 0 ] || return 0
	if ! may_install; then
		fail "packages are missing, and you are not root, and sudo is absent or wants a password. An administrator must run:
    apt-get update && apt-get install --no-install-recommends ${missing[*]}"
	fi
	say "installing ${#missing[@]} Debian packages and what they depend on: ${missing[*]}"
	timed "packages installed" apt_install "${missing[@]}" ||
		fail "apt-get could not install them (see above). Debian 12 has all of them; on an older release MRPT >= 2.5 is missing."
}

# configure NAME=VALUE...: only where the build folder has none yet or was configured otherwise.
configure()
{
	local setting stale=
	[ -f "$build/build.ninja" ] || stale=yes
	for setting in "$@"; do
		grep -qsE "^${setting%%=*}:[A-Z]+=${setting#*=}\$" "$build/CMakeCache.txt" || stale=yes
	done
	[ -z "$stale" ] || (cd "$root" && cmake --preset release "${@/#/-D}" >&2)
}

build() { cmake --build "$build" "$@" >&2; }

run_demo()
{
	install_packages "${demo_packages[@]}"
	configure EXPLORE_APPS=ON EXPLORE_SIMULATION=ON EXPLORE_OPENNI2=ON
	timed "built" build --target explore-mrpt
	local argument out=$root/out/demo
	local -a out_option=(--out "$out")
	for argument in "$@"; do
		case $argument in
		--out | --out=* | --help | --version | --dump-config) out_option=() ;;
		esac
	done
	timed "explored" "$build/apps/explore-mrpt/explore-mrpt" --ini corridor.ini "${out_option[@]}" "$@"
	[ "${#out_option[@]}" -eq 0 ] || say "the results are in $out"
	[ "${#out_option[@]}" -eq 0 ] || [ ! -e "$out/report.html" ] || say "the report to look at: $out/report.html"
}

run_test()
{
	install_packages "${test_packages[@]}"
	configure EXPLORE_APPS=ON EXPLORE_SIMULATION=ON EXPLORE_OPENNI2=ON EXPLORE_TESTS=ON
	timed "built" build
	timed "tested" ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$(nproc)" "$@"
}

command=${1:-help}
[ $# -eq 0 ] || shift
case $command in
demo) run_demo "$@" ;;
test) run_test "$@" ;;
setup)
	case ${1:-} in
	demo) install_packages "${demo_packages[@]}" ;;
	test) install_packages "${test_packages[@]}" ;;
	ci) install_packages "${ci_packages[@]}" ;;
	*) usage >&2 && exit 2 ;;
	esac
	;;
help | -h | --help) usage ;;
*) usage >&2 && exit 2 ;;
esac
