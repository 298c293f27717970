package rasterlab.tests.rules;

/**
 * A function in a source.
 *
 * @param place file and name, for people
 * @param lines from its first to its last
 */
record SourceFunction(String place, int lines) {}
