// Linked into programs when they are built with AddressSanitizer: drivers stay loaded, so that the leak
// checker can name (and lsan.supp suppress) what they leave behind.
extern "C" int dlclose(void*) { return 0; }
