# make.sh FOLDER: two surfaces and two loops
set -e
mkdir -p "$1/rough/stylus" "$1/smooth" "$1/loops"
for file in rough/afm_1.csv rough/stylus/1.csv smooth/line.csv; do
  printf 'x [um],h [nm]\n0,1\n1,2\n2,1\n3,2\n' > "$1/$file"
done
for file in rough_soft.csv reference_soft_after.csv; do
  printf 'force [mN],displacement [um]\n0,0\n1,1\n2,2\n1,1\n' > "$1/loops/$file"
done
