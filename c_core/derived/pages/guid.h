#define FMU_GUID "{b00c1db9-eeae-007f-3f6f-6dab0c2f09c5}"
