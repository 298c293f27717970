/**
 * Methods that look at the picture piece by piece: row after row, and window after window.
 *
 * <p>Space: pixels. Both compare the nearness of the faces that cover a piece. Start with {@link
 * rasterlab.engine.visibility.scan.ScanLine} and {@link rasterlab.engine.visibility.scan.Warnock};
 * {@link rasterlab.engine.visibility.scan.ScreenFaces} holds the faces that they share.
 */
package rasterlab.engine.visibility.scan;
