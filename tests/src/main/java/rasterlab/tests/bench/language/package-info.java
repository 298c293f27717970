/** The words of the benchmarks, in English and in Russian. */
package rasterlab.tests.bench.language;
