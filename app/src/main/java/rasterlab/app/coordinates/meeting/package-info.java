/**
 * The lab of the topic {@code line-plane}: where a line meets a plane, by every method.
 *
 * <p>The stage looks along the plane, which is seen as its edge; lengths are told in those of p₂ −
 * p₁, so that any magnitude has a picture. Start with {@link
 * rasterlab.app.coordinates.meeting.SideView}; {@link
 * rasterlab.app.coordinates.meeting.MeetingLabModel} knows no Swing.
 */
package rasterlab.app.coordinates.meeting;
