/**
 * The processes that students' code runs in: how one is started, what it gets to read, how it is
 * asked, and how its time and the machine's limits are looked after.
 *
 * <p>Nothing here knows what is asked or graded. Start with {@link
 * rasterlab.exercises.runner.process.Child}.
 */
package rasterlab.exercises.runner.process;
