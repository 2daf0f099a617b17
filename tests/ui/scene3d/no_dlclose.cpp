// The OpenGL driver is unloaded before the leak sanitizer reports, which then cannot tell whose memory it sees. So nothing is
// unloaded in these tests.
extern "C" int dlclose(void* /*handle*/) {
  return 0;
}
