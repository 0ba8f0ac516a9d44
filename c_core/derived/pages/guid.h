#define FMU_GUID "{ba7e175c-a0ee-d5c5-c263-7b98d55281d7}"
