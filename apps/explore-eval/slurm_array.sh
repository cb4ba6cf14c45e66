#!/bin/sh
# Scores a list of logs as a Slurm job array, one log a task, and joins the parts when all tasks have ended.
set -eu

usage() {
	cat >&2 <<-END
	Usage: slurm_array.sh [-w] [-r REQUIREMENTS] INI LIST OUT [option of explore-eval]...
	  INI    configuration, as for explore-eval --ini
	  LIST   file with the path of a log a line; empty lines and those that begin with # do not count
	  OUT    folder for the joined results; OUT/parts has those of each log, OUT/slurm what the tasks said
	  -w     waits for the end and returns the exit code of explore-eval merge
	  -r     requirements, as for explore-eval merge --require
	The environment variable EXPLORE_EVAL names the program (default: explore-eval on the PATH of the nodes);
	SBATCH_PARTITION, SBATCH_TIMELIMIT and the like are Slurm's own. All paths must be the same on every node.
	END
	exit 2
}

# A task: the log of this line, into a part of its own. Called by Slurm.
task() {
	program=$1 ini=$2 out=$3 first=$4
	shift 4
	number=$((first + SLURM_ARRAY_TASK_ID))
	log=$(sed -n "${number}p" "$out/slurm/logs.txt")
	exec "$program" --quiet --ini "$ini" "$@" --out "$out/parts/$(printf %06d "$number")" "$log"
}

# The end: all parts, into OUT. Called by Slurm.
join() {
	program=$1 out=$2 requirements=$3
	set -- "$program" merge "$out"/parts/* --out "$out"
	[ -z "$requirements" ] || set -- "$@" --require "$requirements"
	exec "$@"
}

submit() {
	program=${EXPLORE_EVAL:-explore-eval} self=$0 wait='' requirements=''
	while getopts wr: option; do
		case $option in
		w) wait=--wait ;;
		r) requirements=$OPTARG ;;
		*) usage ;;
		esac
	done
	shift $((OPTIND - 1))
	[ $# -ge 3 ] || usage
	ini=$1 list=$2 out=$3
	shift 3

	mkdir -p "$out/slurm"
	rm -rf "$out/parts"
	mkdir "$out/parts"
	grep -v -e '^#' -e '^[[:space:]]*$' "$list" > "$out/slurm/logs.txt" || { echo "$list: names no log" >&2; exit 2; }
	count=$(wc -l < "$out/slurm/logs.txt")

	# Slurm takes arrays of up to 1000 tasks where nothing else is configured.
	first=1 jobs=''
	while [ "$first" -le "$count" ]; do
		last=$((count - first))
		[ "$last" -lt 1000 ] || last=999
		job=$(sbatch --parsable --job-name=explore-eval --array="0-$last" --output="$out/slurm/%A_%a.txt" \
			"$self" task "$program" "$ini" "$out" "$first" "$@")
		jobs=$jobs:${job%%;*}
		first=$((first + 1000))
	done
	echo "submitted $count logs as jobs ${jobs#:}; the joined results will be in $out" >&2
	# afterany: a damaged log makes its task fail, and is scored up to the damage all the same.
	# shellcheck disable=SC2086 # $wait is one option or none
	sbatch --parsable $wait --job-name=explore-eval-merge --dependency="afterany$jobs" \
		--output="$out/slurm/merge.txt" "$self" join "$program" "$out" "$requirements"
}

case ${1-} in
task | join)
	command=$1
	shift
	"$command" "$@"
	;;
*) submit "$@" ;;
esac
