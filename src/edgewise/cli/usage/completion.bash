_edgewise() {
    local at= i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case "${at:+$at }${COMP_WORDS[i]}" in
            @PATHS@) at="${at:+$at }${COMP_WORDS[i]}" ;;
        esac
    done
    local options= nested=
    case "$at" in
@CASES@    esac
    local word=${COMP_WORDS[COMP_CWORD]}
    case "$word" in
        -*) nested=$options ;;
    esac
    COMPREPLY=($(compgen -W "$nested" -- "$word"))
}
complete -o default -F _edgewise edgewise
