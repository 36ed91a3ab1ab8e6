#!/bin/sh
# SPDX-License-Identifier: MIT
#
# check_contraction.sh OBJDUMP PROGRAM: finds packed multiply-adds that the compiler fused. A fused multiply-add rounds once,
# other builds round twice, so answers would differ between machines. The library itself only fuses the error of a product
# (geometry/double_double.hpp), a b - [a b], which may be packed too: its subtrahend is a product of one of its factors.
set -eu

"$1" --disassemble --no-show-raw-insn "$2" | awk -F'\t' '
$2 ~ /^v?mul[sp][sd] / { ++products }
$2 !~ /^v(mul|fn?m(add|sub)[a-z]*[0-9]+)p[sd] / { next }
{
    count = split($2, word, / +/)
    operands = word[2]
    # Commas within an address do not separate operands.
    while (match(operands, /\([^()]*,[^()]*\)/)) {
        address = substr(operands, RSTART, RLENGTH)
        gsub(/,/, ";", address)
        sub(/^\(/, "<", address)
        sub(/\)$/, ">", address)
        operands = substr(operands, 1, RSTART - 1) address substr(operands, RSTART + RLENGTH)
    }
    split(operands, operand, ",")
}
word[1] ~ /^vmul/ {
    factors[operand[3]] = "," operand[1] "," operand[2] ","
    line[operand[3]] = NR
    next
}
{
    # The three orders of operands: which operand is added, and which is certainly a factor.
    added = word[1] ~ /132/ ? operand[2] : word[1] ~ /213/ ? operand[1] : operand[3]
    first = word[1] ~ /213/ ? operand[2] : operand[1]
    second = word[1] ~ /231/ ? operand[2] : operand[3]
    near = (added in factors) && NR - line[added] <= 24
    ours = near && (index(factors[added], "," first ",") || index(factors[added], "," second ","))
    if (word[1] ~ /^vfmsub/ && ours) {
        ++errors_of_products
    } else {
        ++fused
        if (fused <= 5) print "contracted by the compiler: " $0
    }
}
END {
    printf "%d products, %d packed errors of products, %d fused by the compiler\n", products, errors_of_products, fused
    if (products < 1000) print "too few products: the disassembly is not understood"
    exit products < 1000 || fused > 0
}'
