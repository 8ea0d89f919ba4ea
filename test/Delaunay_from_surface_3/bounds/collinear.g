#@ -Eprecision=128 -Eno-auto-dichotomy
# No product of the determinant goes through more than 4 roundings (counted), and their absolute
# values sum up to at most `products`: by the inequality of Cauchy and Schwarz.

@add = add_rel<53>;
@sub = sub_rel<53>;
@mul = mul_rel<53>;

roundings = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) - 1;
M = 1 / (1 + dm); # exactly, where it is 1 as computed
root = sqrt(1) * (1 + dr);
products = M;
bound = add(mul(1b-50, 1), 0);

{ |d1| <= 1b-53
  /\ |d2| <= 1b-53
  /\ |d3| <= 1b-53
  /\ |d4| <= 1b-53
  /\ |dm| <= 81b-57
  /\ |dr| <= 1b-53
->
  |roundings * products| <= 1099511627775b-90
  /\ bound >= 1099511627775b-90 }
