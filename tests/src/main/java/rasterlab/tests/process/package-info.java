/** The calls by which benchmarks and tests start a Java of their own. */
package rasterlab.tests.process;
