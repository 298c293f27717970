/**
 * The stages that every lab draws on: a zoomed pixel grid or a plane, their colours, rulers and
 * words, and the same drawing as SVG. What stands around a stage is in the packages within: {@code
 * lab} lays a lab out, {@code player} steps, {@code method} shows methods, {@code file} saves.
 *
 * <p>Names carry the space: {@code pixel} counts raster pixels, x right and y down, whole numbers
 * at pixel centres; {@code world} is a plane's real coordinates; {@code view} is Swing's inside the
 * stage; {@code device} counts the screen's own dots. Start at {@link PlaneView}.
 */
package rasterlab.app.canvas;
