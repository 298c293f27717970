/**
 * Proves exercises: right methods keep all points, every known mistake is rejected by name, the
 * starter earns next to nothing.
 *
 * <p>Start with {@link rasterlab.exercises.proving.Proving}.
 */
package rasterlab.exercises.proving;
