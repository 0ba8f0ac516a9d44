#define FMU_GUID "{04efb8f0-c9be-c164-19c4-33ebc7b44461}"
