/**
 * Filling polygons row by row: topic {@code polygon-fill}.
 *
 * <p>Pixel coordinates: whole numbers name pixel centres, x grows to the right, y grows down;
 * corners may lie between them. Sources: C. Wylie, G. Romney, D. Evans, A. Erdahl, Half-tone
 * perspective drawings by computer, AFIPS 1967, pp. 49–58; J. Pineda, A parallel algorithm for
 * polygon rasterization, SIGGRAPH 1988, pp. 17–20. Start with {@link
 * rasterlab.engine.polygon.scan.ScanlinePolygon}.
 */
package rasterlab.engine.polygon.scan;
