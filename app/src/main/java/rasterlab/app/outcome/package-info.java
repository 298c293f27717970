/**
 * How a command ends: exit codes, failures that one line explains, and files written whole or not
 * at all.
 *
 * <p>Start with {@link rasterlab.app.outcome.Complaint}.
 */
package rasterlab.app.outcome;
