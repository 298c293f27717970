/**
 * Tests that cross modules: the two builds, the rules of the architecture, the front door, the
 * window, the server as a process and in a browser, each in a package of its own; here is what all
 * of them need. Unit tests stay in their own modules.
 *
 * <p>Tests that want a system part (a display, a browser, bubblewrap) are skipped where it is
 * missing and name it.
 */
package rasterlab.tests;
