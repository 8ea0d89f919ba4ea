#@ -Eprecision=128 -Eno-auto-dichotomy
# No product of the determinant goes through more than 13 roundings (counted), and their absolute
# values sum up to at most `products`: for each w by the inequality of Cauchy and Schwarz.

@add = add_rel<53>;
@sub = sub_rel<53>;
@mul = mul_rel<53>;

roundings = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) * (1 + d9) * (1 + d10) * (1 + d11) * (1 + d12) * (1 + d13) - 1;
M = 1 / (1 + dm); # exactly, where it is 1 as computed
root = sqrt(1) * (1 + dr);
products = 3 * M * M;
bound = add(mul(mul(11b-51, 1), 1), 0);

{ |d1| <= 1b-53
  /\ |d2| <= 1b-53
  /\ |d3| <= 1b-53
  /\ |d4| <= 1b-53
  /\ |d5| <= 1b-53
  /\ |d6| <= 1b-53
  /\ |d7| <= 1b-53
  /\ |d8| <= 1b-53
  /\ |d9| <= 1b-53
  /\ |d10| <= 1b-53
  /\ |d11| <= 1b-53
  /\ |d12| <= 1b-53
  /\ |d13| <= 1b-53
  /\ |dm| <= 97b-57
  /\ |dr| <= 1b-53
->
  |roundings * products| <= 12094627905525b-91
  /\ bound >= 12094627905525b-91 }
