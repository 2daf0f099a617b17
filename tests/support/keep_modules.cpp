// Linked into all tests under sanitizers only. What a graphics driver keeps for its own lifetime counts as lost once it is unloaded, and as kept while it
// is not; and frames of an unloaded module have no names.
extern "C" int dlclose(void* /*handle*/) {
  return 0;
}
