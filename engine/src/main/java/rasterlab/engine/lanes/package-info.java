/**
 * How many numbers are computed at a time: one, in plain Java, or eight, with the Vector API that
 * only some Java machines have and only when asked.
 *
 * <p>What needs the Vector API is compiled apart, from {@code src/vector}, and found by its name,
 * so that the engine runs without it. Results are the same bit for bit. Start with {@link
 * rasterlab.engine.lanes.Lanes}.
 */
package rasterlab.engine.lanes;
