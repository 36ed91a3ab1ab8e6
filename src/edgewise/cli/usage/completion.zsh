#compdef edgewise
_edgewise() {
    local at= i
    for ((i = 2; i < CURRENT; ++i)); do
        case "${at:+$at }${words[i]}" in
            @PATHS@) at="${at:+$at }${words[i]}" ;;
        esac
    done
    local options= nested=
    case "$at" in
@CASES@    esac
    if [[ ${words[CURRENT]} == -* ]]; then
        compadd -- ${=options}
    else
        compadd -- ${=nested}
        _files
    fi
}
_edgewise "$@"
