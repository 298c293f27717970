/**
 * Reads JSON strictly, with messages that name the place.
 *
 * <p>A topic's input is read by {@link rasterlab.exercises.json.StrictJson} as its format says,
 * however long it is; files of people, of which each refusal tells the place in words of the file's
 * own, by a {@link rasterlab.exercises.json.JsonPlace}.
 */
package rasterlab.exercises.json;
