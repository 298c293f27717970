/**
 * Where a straight line of space meets a plane: topic {@code line-plane}.
 *
 * <p>Mathematical axes, any unit: x to the right, y up, z towards the reader. Start with {@link
 * rasterlab.engine.geometry.meeting.TextbookMeeting} and what it lacks.
 */
package rasterlab.engine.geometry.meeting;
