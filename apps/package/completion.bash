# bash completion for explore-mrpt, explore-rawlog and explore-eval: options and subcommands are what --help says.
_explore_mrpt()
{
	local cur prev words cword
	_init_completion || return

	local help subcommand="" word
	help=$("$1" --help 2>/dev/null)
	local subcommands
	subcommands=$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p' <<<"$help")
	for word in "${words[@]:1:cword-1}"; do
		if grep -qxF -e "$word" <<<"$subcommands"; then
			subcommand=$word
			help=$("$1" "$subcommand" --help 2>/dev/null)
			break
		fi
	done

	case $prev in
		--ini)
			COMPREPLY=($(compgen -W "$(cd /usr/share/explore-mrpt/ini 2>/dev/null && echo *.ini)" -- "$cur"))
			_filedir ini
			return
			;;
		--robot) COMPREPLY=($(compgen -W "ground mav" -- "$cur")); return ;;
		--verbosity) COMPREPLY=($(compgen -W "DEBUG INFO WARN ERROR" -- "$cur")); return ;;
		--rawlog) _filedir rawlog; return ;;
		--world) _filedir '@(sdf|world)'; return ;;
		--oni) _filedir oni; return ;;
		--out | --resume) _filedir; return ;;
	esac
	if [[ $cur == -* ]]; then
		COMPREPLY=($(compgen -W "$(grep -oE '^  (-h,)?--[a-z-]+' <<<"$help" | grep -oE -e '--[a-z-]+')" -- "$cur"))
		return
	fi
	[[ -z $subcommand ]] && COMPREPLY=($(compgen -W "$subcommands" -- "$cur"))
	_filedir
} && complete -F _explore_mrpt explore-mrpt explore-rawlog explore-eval
