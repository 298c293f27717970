/** How long the server's judge takes for a student's source. */
package rasterlab.tests.bench.grader;
