/**
 * Reads JSON strictly, with messages that name the place.
 *
 * <p>A topic's input is read by {@link rasterlab.exercises.json.StrictJson} as its format says, an
 * exercise's data by {@link rasterlab.exercises.json.JsonFields}.
 */
package rasterlab.exercises.json;
