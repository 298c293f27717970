/**
 * Topic {@code hidden-surfaces}: whole pictures of scenes by every visibility method, and how their
 * work grows with faces and with pixels.
 *
 * <p>What a method answers is the number of the face that it shows in each pixel; right is what a
 * ray through the pixel meets first, of faces in one plane the earlier. Start with {@link
 * rasterlab.engine.visibility.hidden.HiddenSurfacesTopic}.
 */
package rasterlab.engine.visibility.hidden;
