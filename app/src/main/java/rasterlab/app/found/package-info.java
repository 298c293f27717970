/**
 * Hazards that a search found and the user keeps: files in a folder beside the settings, which the
 * labs show as chips of their topics.
 *
 * <p>Start with {@link rasterlab.app.found.FoundHazards}.
 */
package rasterlab.app.found;
