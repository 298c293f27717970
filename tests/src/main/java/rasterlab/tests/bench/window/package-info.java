/**
 * How fast the window is: its start, frames a second while a picture is dragged, the longest the
 * event thread was busy, and the memory it holds after long use.
 */
package rasterlab.tests.bench.window;
