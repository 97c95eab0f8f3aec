# What every launcher says and is told.

# On a line, whatever was given: no control character gets to the terminal.
say() { printf '%s\n' "${*//[[:cntrl:]]/?}" >&2; }
# A path that the caller gave, from any folder.
of_caller() { case "$1" in /* | [A-Za-z]:*) printf '%s\n' "$1" ;; *) printf '%s\n' "$caller/$1" ;; esac; }
