#!/bin/sh
# Runs explore-eval over the same logs with one set of overrides after another, and compares them all with the first.
set -eu

usage() {
	cat >&2 <<-END
	Usage: compare_sets.sh [-j JOBS] [-c COSTS] SETS OUT [option of explore-eval]... LOG...
	  SETS   file with a run a line: its name, then SECTION.KEY=VALUE ...; the first is what the others are compared
	         with (a name alone: the configuration as it is); empty lines and those that begin with # do not count
	  OUT    folder; OUT/NAME has each run, OUT/compare.txt and OUT/compare.json the comparison
	  -j     logs that are scored at the same time (default: 2)
	  -c     points that a figure may get worse, as for explore-eval compare --cost
	A run whose eval.json is there already is not made again. The environment variable EXPLORE_EVAL names the program
	(default: explore-eval on the PATH).
	END
	exit 2
}

jobs=2 costs=''
while getopts j:c: option; do
	case $option in
	j) jobs=$OPTARG ;;
	c) costs=$OPTARG ;;
	*) usage ;;
	esac
done
shift $((OPTIND - 1))
[ $# -ge 3 ] || usage
sets=$1 out=$2
shift 2
program=${EXPLORE_EVAL:-explore-eval}

# The options of a line of SETS, each --set in front of its value; values hold no blanks.
score() {
	name=$1 overrides=''
	shift
	while [ "$1" != -- ]; do
		overrides="$overrides --set $1"
		shift
	done
	shift
	[ -e "$out/$name/eval.json" ] && return
	echo "run $name:$overrides" >&2
	# shellcheck disable=SC2086 # $overrides is a list of words
	"$program" --quiet --no-pictures --jobs "$jobs" "$@" $overrides --out "$out/$name" > /dev/null || [ $? -eq 3 ]
}

mkdir -p "$out"
grep -v -e '^#' -e '^[[:space:]]*$' "$sets" > "$out/sets.txt" || { echo "$sets: names no run" >&2; exit 2; }
while read -r line; do
	# shellcheck disable=SC2086 # the words of the line
	score $line -- "$@" < /dev/null
done < "$out/sets.txt"

set -- compare
while read -r name _; do
	set -- "$@" "$out/$name"
done < "$out/sets.txt"
[ $# -ge 3 ] || { echo "$sets: names one run only; nothing to compare" >&2; exit 2; }
[ -z "$costs" ] || set -- "$@" --cost "$costs"
exec "$program" "$@" --out "$out"
