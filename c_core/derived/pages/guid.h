#define FMU_GUID "{bf19f037-68dd-da93-0180-57ff482de4ec}"
