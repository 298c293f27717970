/**
 * {@code ./lab tour}: everything that Rasterlab does, made once without a display and shown on one
 * page.
 *
 * <p>Start with {@link rasterlab.app.tour.Tour}; each part of the page is a {@code TourPart}.
 */
package rasterlab.app.tour;
