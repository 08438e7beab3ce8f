# make.sh SETAE FOLDER: a folder with a file of each kind that a text or a picture can be
set -e
mkdir -p "$2/A/.hidden" "$2/loops" "$2/linked_from"
printf 'x [um],h [nm]\n0,1\n1,2\n2,1\n3,2\n' > "$2/A/line.csv"
cp "$2/A/line.csv" "$2/A/.hidden/other.csv"
printf 'force [mN],displacement [um]\n0,0\n1,1\n2,2\n1,1\n' > "$2/loops/soft.csv"
printf 'q [1/um],C1D [nm3]\n1,2\n2,1\n' > "$2/A/spectrum.csv"
printf '[surfaces.A]\nmeasurements = [{ file = "A/line.csv" }]\n' > "$2/study.toml"
printf 'steps:\n  - step: level_plane\n' > "$2/steps.yml"
printf '# Notes\n' > "$2/notes.md"
printf 'P5 is none\n' > "$2/linked_from/far.txt"
mv "$2/linked_from" "$2/../far" && ln -s "$2/../far" "$2/linked"
# two by two pixels, 24 bit a pixel
printf 'BM\106\000\000\000\000\000\000\000\066\000\000\000\050\000\000\000\002\000\000\000\002\000\000\000\001\000\030\000\000\000\000\000\020\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000' > "$2/A/picture.bmp"
printf '\000\000\000\377\377\377\000\000\377\377\377\000\000\000\000\000' >> "$2/A/picture.bmp"
