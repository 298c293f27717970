/**
 * Faces painted one over another, in the order of a list: all of them, only those turned to the
 * eye, and from far to near with what hides each other cut.
 *
 * <p>Spaces: eye, and pixels of the picture. Start with {@link
 * rasterlab.engine.visibility.painter.Painter} and its {@link
 * rasterlab.engine.visibility.painter.TextbookPainter}, then {@link
 * rasterlab.engine.visibility.painter.OrderedPieces}, which paints what the depth orders of {@code
 * visibility.order} cut and sort.
 */
package rasterlab.engine.visibility.painter;
