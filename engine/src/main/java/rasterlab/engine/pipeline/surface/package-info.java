/**
 * Light and textures for the fast pipeline, made of {@code engine.light} and {@code
 * engine.texture}.
 *
 * <p>{@code new LitPixels(lighting)}, {@code new ColoredPixels()}, {@code new
 * TexturedPixels(sampler, filter, environment, under)}, its {@code moved(matrix)}, and {@code new
 * TexelPixels(sampler, filter)} for the texture alone. Light is reckoned in the space that {@link
 * rasterlab.engine.pipeline.fast.TriangleView} calls the eye's; texture coordinates as in {@code
 * engine.texture}. Start with {@link rasterlab.engine.pipeline.surface.TexturedPixels}.
 */
package rasterlab.engine.pipeline.surface;
