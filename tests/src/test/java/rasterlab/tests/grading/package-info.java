/**
 * The grading server as a process of its own, spoken to by HTTP: the round trip, the death and
 * return of the server, the student's page in a browser.
 *
 * <p>Start with {@link rasterlab.tests.grading.RoundTripTest}.
 */
package rasterlab.tests.grading;
