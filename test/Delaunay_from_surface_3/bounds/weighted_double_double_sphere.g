#@ -Eprecision=128 -Eno-auto-dichotomy
# No product of the determinant goes through more than 12 roundings (counted), and their absolute
# values sum up to at most `products`: for each w by an inequality of Hadamard type for permanents (Carlen, Lieb, Loss 2006).

@add = add_rel<53>;
@sub = sub_rel<53>;
@mul = mul_rel<53>;

roundings = (1 + d1) * (1 + d2) * (1 + d3) * (1 + d4) * (1 + d5) * (1 + d6) * (1 + d7) * (1 + d8) * (1 + d9) * (1 + d10) * (1 + d11) * (1 + d12) - 1;
M = 1 / (1 + dm); # exactly, where it is 1 as computed
root = sqrt(1) * (1 + dr);
products = 4 * (2 / sqrt(3)) * M * M * sqrt(M);
bound = add(mul(1b-93, mul(mul(1, 1), root)), 0);

{ |d1| <= 1b-100
  /\ |d2| <= 1b-100
  /\ |d3| <= 1b-100
  /\ |d4| <= 1b-100
  /\ |d5| <= 1b-100
  /\ |d6| <= 1b-100
  /\ |d7| <= 1b-100
  /\ |d8| <= 1b-100
  /\ |d9| <= 1b-100
  /\ |d10| <= 1b-100
  /\ |d11| <= 1b-100
  /\ |d12| <= 1b-100
  /\ |dm| <= 97b-57
  /\ |dr| <= 1b-53
->
  |roundings * products| <= 1099511627775b-133
  /\ bound >= 1099511627775b-133 }
