/**
 * Reads and writes the JSON documents that our own programs make for each other.
 *
 * <p>Start with {@link rasterlab.exercises.document.OwnJson}. What people write or send is read by
 * {@code rasterlab.exercises.json}, which tells them what is wrong and where.
 */
package rasterlab.exercises.document;
