/**
 * Which faces of a body are turned towards the eye: topic {@code visible-faces}.
 *
 * <p>World space, any unit; faces go counter-clockwise seen from outside, so their normals point
 * outwards. Each method is a walk that judges one face per step: start with {@link
 * rasterlab.engine.visibility.faces.BackFace} and {@link
 * rasterlab.engine.visibility.faces.FaceSide}; {@link
 * rasterlab.engine.visibility.faces.VisibleFacesTopic} lists everything.
 */
package rasterlab.engine.visibility.faces;
