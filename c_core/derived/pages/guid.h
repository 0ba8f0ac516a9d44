#define FMU_GUID "{c18064b1-6fac-113a-d4cd-ea0fdac4d5d3}"
