/**
 * The JSON form of a report, in one language: the shape that the HTTP API and {@code ./lab check
 * --json} share.
 *
 * <p>Start with {@link rasterlab.exercises.published.PublishedReport}.
 */
package rasterlab.exercises.published;
