#!/usr/bin/env bash
# Makes the pictures of the gallery again, from docs/gallery.txt, and the page that shows them.
#   bash docs/make.sh                  all of them
#   bash docs/make.sh flag.webp ...    only these
#   bash docs/make.sh --page FILE      only the page, into another file
set -euo pipefail
docs=$(cd "$(dirname "$0")" && pwd)
list=$docs/gallery.txt
program=${TAUT_PROGRAM:-$docs/../build/release/taut}

# Calls with file, title and command of each picture: entries are three lines each, with empty lines between.
for_each_picture() {
  local file title command
  while IFS= read -r file; do
    [[ -z $file || $file == \#* ]] && continue
    IFS= read -r title
    IFS= read -r command
    "$@" "$file" "$title" "$command" < /dev/null
  done < "$list"
}

escaped() { sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g' <<< "$1"; }

card() {
  printf '<figure>\n<a href="%s"><img src="%s" alt="%s" loading="lazy"></a>\n<figcaption>%s<code>%s</code></figcaption>\n</figure>\n' \
    "$1" "$1" "$(escaped "$2")" "$(escaped "$2")" "$(escaped "$3")"
}

page() {
  cat <<'HTML'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>taut: gallery</title>
<style>
:root { color-scheme: light dark; }
body { font: 16px/1.45 "DejaVu Sans", Verdana, sans-serif; margin: 2rem auto; max-width: 78rem; padding: 0 1rem;
       color: light-dark(#1a1e24, #e8eaee); background: light-dark(#fafbfc, #14161a); }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(20rem, 1fr)); gap: 1.5rem; }
figure { margin: 0; }
img { width: 100%; height: auto; border-radius: 6px; display: block; background: #fff; }
figcaption { padding: .5rem .1rem; }
code { display: block; font-size: .75rem; margin-top: .35rem; overflow-wrap: anywhere; color: light-dark(#4a515b, #aab1bb); }
</style>
</head>
<body>
<h1>What <code style="display:inline;font-size:inherit">taut</code> draws</h1>
<p>Each picture comes from the command below it, run in the folder <code style="display:inline">docs</code>.</p>
<main>
HTML
  for_each_picture card
  printf '</main>\n</body>\n</html>\n'
}

make_picture() {
  local wanted=" ${only[*]-} " file=$1 command=$3
  if ((${#only[@]})) && [[ $wanted != *" $file "* ]]; then return; fi
  echo "$file"
  taut() { "$program" "$@"; }
  (cd "${TAUT_GALLERY:-$docs}" && eval "$command")
}

if [[ ${1-} == --page ]]; then
  page > "$2"
  exit
fi
only=("$@")
for_each_picture make_picture
((${#only[@]})) || page > "$docs/gallery.html"
