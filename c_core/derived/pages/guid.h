#define FMU_GUID "{cfe45596-2bca-6416-067c-1a0c83d0f0e3}"
