/**
 * Hazards as a page: the table of verdicts, and for each verdict its picture, what is wrong and the
 * command that repeats it.
 *
 * <p>Start with {@link rasterlab.app.hazard.HazardPage}.
 */
package rasterlab.app.hazard;
