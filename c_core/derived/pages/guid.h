#define FMU_GUID "{17fc6a3a-00a4-cf29-043c-1c1e661de0f9}"
