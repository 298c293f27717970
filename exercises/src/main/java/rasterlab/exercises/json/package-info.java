/**
 * Reads JSON strictly, with messages that name the place.
 *
 * <p>{@link rasterlab.exercises.json.StrictJson} is the one reader of values. It reads the text of
 * a topic's input as its format says, however long it is; and each value of a file of people, whose
 * fields are asked for one by one at a {@link rasterlab.exercises.json.JsonPlace} of its tree.
 * {@link rasterlab.exercises.json.JsonText} makes the trees of what people write or send. {@link
 * rasterlab.exercises.json.Expected} says what is allowed, {@link
 * rasterlab.exercises.json.Refusals} in which way the rest is refused, {@link
 * rasterlab.exercises.json.JsonMistake} where a text is no JSON. An input has no tree: one of a
 * million points takes four times as long as the text and more than 200 MiB.
 */
package rasterlab.exercises.json;
