/**
 * The lab of lists of transformations: named matrices in the order in which a program writes them,
 * and the two readings of such a list.
 *
 * <p>Points are rows: the image of p under the list L1, L2, …, Ln is {@code p · Ln · … · L2 · L1}.
 * Read backwards, objects move in fixed axes; read forwards, the frame moves in which the object is
 * given. Start with {@link rasterlab.app.coordinates.list.ListScene}.
 */
package rasterlab.app.coordinates.list;
