/**
 * The commands that draw pictures of scenes in software: {@code render} and {@code opengl}, and
 * their options with units and ranges. Start reading at {@link
 * rasterlab.app.cli.render.RenderCommand}.
 */
package rasterlab.app.cli.render;
