# Drawing. The book's own figures are those in figures/; whatever is drawn in another way goes to a folder of its own,
# with a page to choose from.

gnuplot_of_the_book="gnuplot 5.4 patchlevel 4"

figures_usage() {
  cat <<'EOF'
usage: ./course figures [NAME ...] [--format svg|png|pdf] [--theme light|dark|grey] [--lang en|zh-TW]
                        [--style FILE] [--into DIR]

Without an option the book's own figures are drawn, in figures/. With one they go to a folder of their own (--into, or
out/figures-FORMAT-THEME-LANG), with an index.html that shows them all with their captions.
NAME is a chapter (plane, 01_plane) or a figure (figure-13, 04_general_sphere/bunny); without one all are drawn.
FILE has gnuplot commands that are read after the house style: sizes, letters, colours; see README.md.
EOF
}

# one_of OPTION VALUE CHOICE ...: refuses a value that is none of the choices.
one_of() {
  local option=$1 value=$2 choice
  shift 2
  for choice in "$@"; do [[ "$value" != "$choice" ]] || return 0; done
  say "course: figures $option '$value': must be one of $(IFS='|'; echo "$*")"
  exit 2
}

# All chapters of which a name speaks, a line each: CHAPTER or CHAPTER/FIGURE.
figures_named() {
  local name=$1 chapter script found=""
  for chapter in $(chapters); do
    [[ "$name" != "$chapter" && "$name" != "${chapter#*_}" ]] || { echo "$chapter"; return; }
  done
  for script in figures/*/"${name##*/}.gp"; do
    chapter=${script#figures/}
    [[ -f "$script" && ("$name" != */* || "$name" == "${chapter%.gp}") ]] || continue
    echo "${chapter%.gp}"
    found=yes
  done
  [[ -n "$found" ]] || return 1
}

# Refuses a folder among the book's own figures, there or still to be made, or one with a link into them.
must_not_be_the_books() {
  local place
  for place in "$1" "$1"/*/; do
    while [[ ! -d "$place" ]]; do place=$(dirname -- "$place"); done
    [[ "$(cd -- "$place" && pwd -P)/" == "$(pwd -P)/figures/"* ]] || continue
    say "course: figures --into $1: must not be where the book's own figures are"
    exit 2
  done
}

figure_options() {
  format=svg theme=light lang=en style="" into="" own="" names=""
  while (($#)); do
    local option=${1%%=*} value=""
    case "$1" in
      --help) figures_usage; exit 0 ;;
      --*=*) value=${1#*=} ;;
      --*) (($# > 1)) && [[ "$2" != --* ]] || { say "course: figures $1: must have a value"; exit 2; }
           value=$2; shift ;;
      *) figures_named "$1" >/dev/null || { say "course: figures '$1': must be a chapter or a figure"; exit 2; }
         names="$names $(echo $(figures_named "$1"))"; shift; continue ;;
    esac
    shift
    own=yes
    case "$option" in
      --format) one_of --format "$value" svg png pdf; format=$value ;;
      --theme) one_of --theme "$value" light dark grey; theme=$value ;;
      --lang) one_of --lang "$value" en zh-TW; lang=$value ;;
      --style) style=$(of_caller "$value")
               [[ -n "$value" && -f "$style" && -r "$style" ]] || { say "course: figures --style '$value': must be a file that can be read"; exit 2; } ;;
      --into) [[ -n "$value" ]] || { say "course: figures --into '': must name a folder"; exit 2; }
              into=$(of_caller "$value") ;;
      *) say "course: figures $option: must be an option that ./course figures --help lists"; exit 2 ;;
    esac
  done
  [[ -z "$into" ]] || must_not_be_the_books "$into"
  [[ -n "$own" ]] || into=figures
  [[ -n "$into" ]] || into=out/figures-$format-$theme-$lang
}

draw_figures() {
  figure_options "$@"
  require course
  if [[ "$into" == figures ]]; then writable build figures figures/*/; else writable build "$into"; fi
  local wanted
  wanted=$(printf '%s\n' ${names:-$(chapters)} | sed 's,/.*,,' | sort -u)
  say "Building ..."
  make dev $(printf '%s\n' $wanted | sed 's/^[0-9]*_//')
  say "Drawing ..."
  rm -rf build/drawn
  printf '%s\n' $wanted | program_options="--format $format --theme $theme --lang $lang" style_file=$style bins=$build/bin \
    xargs -P "$(cores)" -I{} bash -c '"$bins/${1#*_}" --out "build/drawn/$1" $program_options \
      ${style_file:+--style "$style_file"} >/dev/null 2>&3 || exit 255' _ {} 3>&2 2>/dev/null || exit 1
  if [[ "$into" == figures ]]; then take_over_book; else take_over_own; fi
}

# Has a figure been asked for, by its chapter or by its own name?
is_wanted() {
  local figure=${1#build/drawn/}
  figure=${figure%.*}
  [[ -z "$names" ]] || case " $names " in *" $figure "* | *" ${figure%/*} "*) ;; *) return 1 ;; esac
}

# Puts a file in its place, whole or not at all.
put() {
  cmp -s "$1" "$2" && return
  mkdir -p "$(dirname "$2")"
  { cp "$1" "$2.part" && mv -f "$2.part" "$2"; } || { rm -f "$2.part"; return 1; }
}

# A picture is renewed where its script has changed. The gnuplot that drew the book renews it in any case: others draw the
# same picture with other words.
take_over_book() {
  local script picture target kept=0 all=0
  [[ "$(gnuplot --version 2>/dev/null)" == "$gnuplot_of_the_book" ]] && local pinned=yes
  for script in build/drawn/*/*.gp; do
    is_wanted "$script" || continue
    target=figures/${script#build/drawn/}
    all=$((all + 1))
    for picture in "${script%.gp}".svg "${script%.gp}".gif; do
      [[ -f "$picture" ]] || continue
      if [[ -n "${pinned:-}" ]] || ! cmp -s "$script" "$target" || [[ ! -f "${target%.gp}.${picture##*.}" ]]; then
        put "$picture" "${target%.gp}.${picture##*.}"
      else
        kept=$((kept + 1))
      fi
    done
    put "$script" "$target"
  done
  say "The figures are in figures/: $all scripts, each with its picture."
  ((kept == 0)) || say "$kept pictures were kept, their scripts being unchanged; as this gnuplot draws them they are in build/drawn/."
}

take_over_own() {
  local file count=0
  for file in build/drawn/*/*; do
    is_wanted "$file" || continue
    put "$file" "$into/${file#build/drawn/}"
    [[ "$file" != *.gp ]] || count=$((count + 1))
  done
  write_index >build/drawn/index.html
  put build/drawn/index.html "$into/index.html"
  say "$count figures are in $into; look at them in $into/index.html."
}

# FIGURE<tab>CAPTION<tab>DESCRIPTION for each figure that an essay shows: what stands below it there, its few formulas as
# plain letters, and what it tells to those who do not see it.
captions() {
  awk '/^!\[.*\]\(.*figures\// { name = seen = $0; sub(/.*figures\//, "", name); sub(/\.svg.*/, "", name)
                                 sub(/^!\[/, "", seen); sub(/\]\(.*/, "", seen); words = ""; next }
       name != "" && /^[[:space:]]*$/ { print name "\t" words "\t" seen; name = "" }
       name != "" { sub(/^\{#[^}]*\} */, ""); words = words (words == "" ? "" : " ") $0 }
       END { if (name != "") print name "\t" words "\t" seen }' chapters/*/*.md |
    sed -e 's/&/\&amp;/g; s/</\&lt;/g; s/"/\&quot;/g; s/{{[^}]*}}/…/g; s/\\vec *//g; s/\\,//g; s/\\cdot/·/g; s/\\perp/⊥/g' \
        -e 's/\\theta/θ/g; s/\\text//g; s/\\tfrac\(.\)\(.\)/\1\/\2/g; s/[$*{}]//g; s/\[\([^]]*\)\]([^)]*)/\1/g'
}

write_index() {
  local all file name caption seen
  all=$(captions)
  cat <<EOF
<!doctype html>
<html lang="$lang"><meta charset="utf-8"><title>First Contact: figures</title>
<meta name="viewport" content="width=device-width">
<style>
  body { font: 16px/1.5 serif; margin: 2rem auto; max-width: 74rem; padding: 0 1rem;
         display: grid; grid-template-columns: repeat(auto-fill, minmax(20rem, 1fr)); gap: 2rem; }
  figure { margin: 0; } img, iframe { width: 100%; } iframe { height: 18rem; border: 0; }
</style>
EOF
  for file in "$into"/*/*."$format" "$into"/*/*.gif; do
    [[ -f "$file" ]] || continue
    name=${file#"$into"/}
    IFS=$'\t' read -r caption seen <<<"$(printf '%s\n' "$all" | awk -F '\t' -v name="${name%.*}" \
      '$1 == name { print $2 "\t" $3; exit }')" || true
    echo "<figure><a href=\"$name\">"
    if [[ "$name" == *.pdf ]]; then echo "<iframe loading=\"lazy\" src=\"$name\"></iframe>"; else echo "<img src=\"$name\" alt=\"$seen\">"; fi
    echo "</a><figcaption><b>$name</b> $caption</figcaption></figure>"
  done
  echo "</html>"
}
