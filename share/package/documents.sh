#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# documents.sh PROGRAM FOLDER: writes completion/frana (bash), completion/_frana (zsh) and man/*.1, man/*.5 into a folder, from what
# the program prints as its help and as its keys.
set -eu
program=$1 folder=$2
mkdir -p "$folder/completion" "$folder/man"

commands=$("$program" --help | awk '/^  [a-z]/ && $1 != "frana" && !seen[$1]++ { print $1 }')
options_of() { "$program" "$1" --help | awk 'sub(/^  (-[a-z] \[ )?--/, "--") { print $1 }'; }
keys=$("$program" params --ini | awk -F '[][]' '/^\[/ { section = $2 }
  match($0, /^(# )?[a-z0-9-]+ =/) { key = $0; sub(/^# /, "", key); sub(/ =.*/, "", key); print section "." key "=" }')
one_line() { printf '%s ' $1; }

{
  echo '# bash completion of frana
_frana() {
    local word=${COMP_WORDS[COMP_CWORD]} words=
    if ((COMP_CWORD == 1)); then
        words="'"$(one_line "$commands")"'--help --version"
    elif [[ ${COMP_WORDS[COMP_CWORD - 1]} == --set ]]; then
        words="'"$(one_line "$keys")"'"
        compopt -o nospace
    elif [[ $word == -* ]]; then
        case ${COMP_WORDS[1]} in'
  for command in $commands; do echo "        $command) words='$(one_line "$(options_of "$command")")--allow-network' ;;"; done
  echo '        esac
    fi
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _frana frana'
} > "$folder/completion/frana"

{
  echo '#compdef frana
if (( CURRENT == 2 )); then
    compadd -- '"$(one_line "$commands")"'--help --version
elif [[ $words[CURRENT-1] == --set ]]; then
    compadd -S "" -- '"$(one_line "$keys")"'
elif [[ $words[CURRENT] == -* ]]; then
    case $words[2] in'
  for command in $commands; do echo "    $command) compadd -- $(one_line "$(options_of "$command")")--allow-network ;;"; done
  echo '    esac
else
    _files
fi'
} > "$folder/completion/_frana"

# page NAME SECTION SUMMARY: a manual page with the text of stdin as it is.
page() {
  {
    printf '.TH %s %s "" "frana"\n.SH NAME\n%s \\- %s\n.SH DESCRIPTION\n.nf\n' \
      "$(printf %s "$1" | tr a-z A-Z | sed 's/-/\\-/g')" "$2" "$(printf %s "$1" | sed 's/-/\\-/g')" "$3"
    sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^[.']/\\\\\\&&/"
    echo '.fi'
  } > "$folder/man/$1.$2"
}
"$program" --help | page frana 1 'run-out of landslides'
"$program" params --ini | page frana-scene 5 'every key of a scene file'
for command in $commands; do
  summary=$("$program" "$command" --help | awk '/^$/ { text = 1; next } text { sub(/\.$/, ""); print; exit }')
  "$program" "$command" --help | page "frana-$command" 1 "$(printf %s "$summary" | sed -e 's/\\/\\e/g' -e 's/-/\\-/g')"
done
