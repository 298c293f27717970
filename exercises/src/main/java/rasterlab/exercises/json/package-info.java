/**
 * Reads an exercise's JSON strictly, with messages that name the place.
 *
 * <p>Start with {@link rasterlab.exercises.json.JsonFields}.
 */
package rasterlab.exercises.json;
