/**
 * Reads JSON strictly, with messages that name the place.
 *
 * <p>A topic's input is read by {@link rasterlab.exercises.json.StrictJson} as its format says,
 * however long it is; files of people, of which each refusal tells the place in words of the file's
 * own, by a {@link rasterlab.exercises.json.JsonPlace}. Both follow the same fields of the format.
 * They are two since a tree of a million points takes six times as long as the stream and more than
 * 200 MiB, while a file of people is read field by field in any order.
 */
package rasterlab.exercises.json;
