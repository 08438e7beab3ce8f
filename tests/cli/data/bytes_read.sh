# SPDX-License-Identifier: GPL-3.0-or-later
# bytes_read.sh SETAE FOLDER: what `setae info` reads of a sparse array of 1 GB; the kernel counts it for this shell and what it waited for.
file=$2/large.npy
printf "\\223NUMPY\\001\\000\\166\\000%-117s\\n" "{'descr': '<f8', 'fortran_order': False, 'shape': (16384, 8192), }" > "$file"
truncate -s $((128 + 16384 * 8192 * 8)) "$file"
counted() { while read -r name count; do [ "$name" = rchar: ] && echo "$count"; done < /proc/$$/io; }
before=$(counted)
"$1" info "$file" --size "2 mm x 1 mm" --unit um || exit 1
after=$(counted)
[ $((after - before)) -lt 1000000 ] && echo "less than 1 MB was read" || echo "$((after - before)) bytes were read"
