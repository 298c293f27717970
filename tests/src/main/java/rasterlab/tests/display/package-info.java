/**
 * The display, which the processes of tests and benchmarks take in turn and leave at rest. Without
 * one, tests of windows are skipped.
 */
package rasterlab.tests.display;
