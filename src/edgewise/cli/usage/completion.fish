function __edgewise_at
    set -l at
    for word in (commandline -opc)[2..-1]
        contains -- "$(string join ' ' $at $word)" @PATHS@ && set at $at $word
    end
    test "$at" = "$argv"
end
